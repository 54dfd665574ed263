// Two routes to the same seen fractions: walking over the surface, and clipping every facet.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>

#include "lrcs/visibility.h"
#include "mesh/read_mesh.h"
#include "tests/lrcs/test_targets.h"

namespace lrcs {
namespace {

using Random = std::mt19937_64;

double real(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
int whole(Random& random, int low, int high) {
  return std::uniform_int_distribution<int>(low, high)(random);
}
Vec3 anywhere(Random& random, double size = 1.0) {
  return {real(random, -size, size), real(random, -size, size), real(random, -size, size)};
}

Vec3 along_an_axis(Random& random) {
  Vec3 d = Vec3::Zero();
  d[whole(random, 0, 2)] = whole(random, 0, 1) == 0 ? 1.0 : -1.0;
  return d;
}

// The share of facets that had to be clipped.
double expect_same(const FacetMesh& given, const Vec3& di, const Vec3& dr) {
  FacetMesh mesh = given;
  measure_facets(mesh);
  const Visibility visibility(mesh);
  VisibilityCost cost;
  const auto walked = visibility.seen_fraction(di, dr, &cost);
  const auto clipped = visibility.seen_fraction_by_clipping(di, dr);
  double area = 0.0, area_clipped = 0.0, bound = 0.0;
  for (std::size_t k = 0; k < mesh.size(); ++k) {
    EXPECT_LE(std::abs(walked[k].value - clipped[k].value), walked[k].bound + clipped[k].bound) << "facet " << k;
    const double full = mesh.areas[k] * std::abs(mesh.normals[k].dot(dr));
    area += full * walked[k].value;
    area_clipped += full * clipped[k].value;
    bound += full * (walked[k].bound + clipped[k].bound);
  }
  EXPECT_NEAR(area, area_clipped, 1e-10 * area_clipped + bound);
  return static_cast<double>(cost.clipped) / static_cast<double>(mesh.size());
}

void expect_same_on(unsigned seeds, const std::function<FacetMesh(Random&)>& make) {
  for (unsigned seed = 0; seed < seeds; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const FacetMesh mesh = make(random);
    const Vec3 d = seed % 3 == 0 ? along_an_axis(random) : random_direction(random);
    expect_same(mesh, d, seed % 2 == 0 ? d : random_direction(random));
  }
}

TEST(WalkAgainstClipping, OnSoups) {
  expect_same_on(60, [](Random& random) { return random_soup(random, whole(random, 5, 150)); });
}

FacetMesh boxes_on_a_grid(Random& random) {
  FacetMesh mesh;
  for (int k = whole(random, 2, 9); k > 0; --k) {
    const Vec3 low(whole(random, 0, 5), whole(random, 0, 5), whole(random, 0, 5));
    add_box(mesh, low, low + Vec3(whole(random, 1, 3), whole(random, 1, 3), whole(random, 1, 3)));
  }
  return mesh;
}

TEST(WalkAgainstClipping, OnBoxesThatTouchAndPassThroughEachOther) {
  expect_same_on(120, boxes_on_a_grid);
}

// Turned, plates that lay in one plane do so but for rounding.
TEST(WalkAgainstClipping, OnTurnedBoxes) {
  expect_same_on(60, [](Random& random) {
    FacetMesh mesh = boxes_on_a_grid(random);
    const Eigen::AngleAxisd turn(real(random, 0, 6), random_direction(random));
    for (Vec3& p : mesh.positions) p = turn * p;
    return mesh;
  });
}

TEST(WalkAgainstClipping, OnFacetsOfAGridFullOfCoincidences) {
  expect_same_on(120, [](Random& random) {
    FacetMesh mesh;
    const auto p = [&] { return Vec3(whole(random, 0, 3), whole(random, 0, 3), whole(random, 0, 3)); };
    for (int k = whole(random, 4, 60); k > 0; --k) add_triangle(mesh, p(), p(), p());
    return mesh;
  });
}

TEST(WalkAgainstClipping, OnCoplanarFacets) {
  expect_same_on(60, [](Random& random) {
    FacetMesh mesh;
    const Vec3 u = random_direction(random), v = u.unitOrthogonal();
    const auto p = [&] { return Vec3(whole(random, 0, 4) * u + whole(random, 0, 4) * v); };
    for (int k = whole(random, 3, 30); k > 0; --k) add_triangle(mesh, p(), p(), p());
    return mesh;
  });
}

TEST(WalkAgainstClipping, OnFacetsThatCrossAtTinyAngles) {
  expect_same_on(80, [](Random& random) {
    FacetMesh mesh;
    const double tilt = std::pow(10.0, real(random, -16, -3));
    const auto p = [&] { return Vec3(real(random, -1, 1), real(random, -1, 1), tilt * real(random, -1, 1)); };
    for (int k = whole(random, 4, 40); k > 0; --k) add_triangle(mesh, p(), p(), p());
    return mesh;
  });
}

TEST(WalkAgainstClipping, OnNeedles) {
  expect_same_on(60, [](Random& random) {
    FacetMesh mesh = random_soup(random, 10);
    for (int k = 0; k < 30; ++k) {
      const Vec3 p = anywhere(random), q = anywhere(random);
      const double thin = std::pow(10.0, real(random, -12, -1));
      add_triangle(mesh, p, q, p + real(random, 0, 1) * (q - p) + thin * anywhere(random));
    }
    return mesh;
  });
}

TEST(WalkAgainstClipping, OnFansAndFlatFacetsAtGrazingAngles) {
  expect_same_on(40, [](Random& random) {
    FacetMesh mesh;
    const auto tip = add_vertex(mesh, {0, 0, real(random, 0, 1e-3)});
    const int rays = whole(random, 3, 300);
    for (int k = 0; k < rays; ++k) {
      const double a = 2 * std::numbers::pi * k / rays;
      add_vertex(mesh, {std::cos(a), std::sin(a), real(random, -1e-4, 1e-4)});
    }
    for (int k = 0; k < rays; ++k)
      add_facet(mesh, tip, tip + 1 + static_cast<std::uint32_t>(k),
                tip + 1 + static_cast<std::uint32_t>((k + 1) % rays));
    return mesh;
  });
}

TEST(WalkAgainstClipping, OnABumpySphereWithHolesAndAnOpenedOne) {
  expect_same_on(12, [](Random& random) {
    FacetMesh mesh = sphere(1.0, 24);
    for (Vec3& p : mesh.positions) p *= 1.0 + 0.2 * std::sin(7 * p.x()) * std::sin(9 * p.y() + 1);
    FacetMesh left;
    left.positions = mesh.positions;
    for (const auto& f : mesh.facets)
      if (random() % 40 != 0) add_facet(left, f[0], f[1], f[2]);
    return random() % 2 == 0 ? mesh : left;
  });
}

TEST(WalkAgainstClipping, AtAnyScaleAndFarFromTheOrigin) {
  for (const double scale : {1e-9, 1e-3, 1e6, 1e9})
    for (const double offset : {0.0, 1e6}) {
      SCOPED_TRACE(testing::Message() << "scale " << scale << ", offset " << offset);
      Random random(5);
      FacetMesh mesh = random_soup(random, 80);
      for (Vec3& p : mesh.positions) p = scale * (p + Vec3(offset, -offset, offset));
      const Vec3 d = random_direction(random);
      expect_same(mesh, d, d);
    }
}

// Every facet has another one in its place: which is nearer hangs on the rank alone, wherever the target lies.
TEST(WalkAgainstClipping, OnCoincidentShellsFarFromTheOrigin) {
  for (const double offset : {0.0, 1e2, 1e4, 1e6, 1e8}) {
    SCOPED_TRACE(testing::Message() << "offset " << offset);
    Random random(3);
    const FacetMesh shell = sphere(1.0, 8);
    FacetMesh mirrored = shell;
    for (auto& f : mirrored.facets) std::swap(f[1], f[2]);
    for (const FacetMesh* other : {&shell, static_cast<const FacetMesh*>(&mirrored)}) {
      FacetMesh mesh = shell;
      append(mesh, *other);
      for (Vec3& p : mesh.positions) p += Vec3(offset, -offset, offset);
      expect_same(mesh, random_direction(random), random_direction(random));
      const Vec3 d = random_direction(random);
      expect_same(mesh, d, d);
    }
  }
}

TEST(WalkAgainstClipping, OnAFlatGridNeedsFewQueries) {
  FacetMesh mesh;
  add_tiled_plate(mesh, {0, 0, 0.7}, {3, 0, 0}, {0, 9, 0}, 30);
  measure_facets(mesh);
  VisibilityCost cost;
  const Vec3 d = Vec3(0.3, 0.4, 1.0).normalized();
  for (const Estimate& seen : Visibility(mesh).seen_fraction(d, d, &cost)) EXPECT_EQ(seen.value, 1.0);
  EXPECT_LT(cost.queries, 10U);
}

TEST(WalkAgainstClipping, OnOneHugeFacetBesideTinyOnes) {
  expect_same_on(20, [](Random& random) {
    FacetMesh mesh = random_soup(random, 60);
    for (Vec3& p : mesh.positions) p *= 1e-3;
    add_triangle(mesh, {-500, -500, -0.002}, {700, -500, -0.0021}, {0, 900, -0.0019});
    return mesh;
  });
}

class Shipped : public testing::TestWithParam<std::string> {};

TEST_P(Shipped, WalkAgreesWithClippingFromAnywhere) {
  const FacetMesh mesh = read_mesh(std::string(LRCS_EXAMPLES) + GetParam());
  Random random(19);
  for (int k = 0; k < 5; ++k) {
    const Vec3 d = k < 2 ? along_an_axis(random) : random_direction(random);
    // All but a few facets are settled without clipping.
    EXPECT_LT(expect_same(mesh, d, k % 2 == 0 ? d : random_direction(random)), 0.01);
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, Shipped,
                         testing::Values("/tess/tess.obj", "/turbine/turbine.off", "/propeller/propeller.stl"));

}  // namespace
}  // namespace lrcs
