// Laws that hold for any target (docs/methods.md, section 5), on seeded random ones: open, interpenetrating, many
// facets.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "mesh/body_frame.h"
#include "tests/lrcs/test_targets.h"

namespace lrcs {
namespace {

struct Case {
  Target target;
  Vec3 di, dr;
};

// Soups, boxes through each other, a sphere through a plate; monostatic and bistatic; every model.
std::vector<Case> cases() {
  std::mt19937_64 random(1234);
  std::vector<FacetMesh> meshes;
  for (int k = 0; k < 4; ++k) meshes.push_back(random_soup(random, 150));
  FacetMesh boxes;
  add_box(boxes, {-1, -1, -1}, {1, 1, 1});
  add_box(boxes, {-0.5, -2, -0.3}, {0.6, 2, 0.4});
  add_box(boxes, {1, -0.5, -0.5}, {2, 0.5, 0.5});  // stands on a face of the first
  meshes.push_back(boxes);
  FacetMesh pierced = sphere(0.7, 12);
  add_plate(pierced, {-1, -1, 0.1}, {2, 0, 0.3}, {0, 2, -0.2});
  meshes.push_back(pierced);
  std::vector<Case> all;
  const char* names[] = {"metal-skin-5p", "painted-steel-9p"};
  for (std::size_t k = 0; k < meshes.size(); ++k) {
    const Brdf brdf = k % 3 == 0 ? lambert(0.6) : library(names[k % 2]);
    const Vec3 di = random_direction(random), dr = random_direction(random);
    all.push_back({target_of(meshes[k], brdf), di, di});
    all.push_back({target_of(meshes[k], brdf), di, dr});
  }
  return all;
}

void expect_same(const Case& a, const Case& b, double factor, const char* what) {
  const CrossSection one = section_of(a.target, a.di, a.dr), other = section_of(b.target, b.di, b.dr);
  const double scale = std::max(std::abs(factor * one.sigma.value), 1e-12);
  EXPECT_NEAR(factor * one.sigma.value, other.sigma.value, 1e-11 * scale) << what;
  EXPECT_LE(std::abs(factor * one.sigma.value - other.sigma.value), factor * one.sigma.bound + other.sigma.bound)
      << what;
  EXPECT_NEAR(factor * one.seen_area, other.seen_area, 1e-11 * std::max(factor * one.seen_area, 1e-12)) << what;
}

TEST(Metamorphic, SigmaGrowsWithTheSquareOfTheLength) {
  for (const Case& c : cases()) {
    Case scaled = c;
    for (Vec3& p : scaled.target.mesh.positions) p *= 3.0;
    measure_facets(scaled.target.mesh);
    expect_same(c, scaled, 9.0, "scaled by 3");
  }
}

TEST(Metamorphic, TheUnitOfTheFileChangesNothingButTheScale) {
  // Two overlapping facets exactly in the plane x + y + z = 10, one white and one black: which is first is a matter of
  // rank, and stays one in every unit.
  FacetMesh mesh;
  add_triangle(mesh, {10, 0, 0}, {0, 10, 0}, {0, 0, 10});
  add_triangle(mesh, {7, 1, 2}, {1, 8, 1}, {2, 3, 5});
  Target target = target_of(mesh, lambert(0.0));
  target.materials.push_back({"white", lambert(1.0), 0.0, ""});
  target.material = {1, 0};
  const Vec3 d = Vec3(0.6, 0.4, 0.3).normalized();
  const double sigma = section_of(target, d, d).sigma.value;
  for (const double unit : {1e-3, 1e-2, 0.0254, 0.3048, 1e3}) {
    Target other = target;
    place_in_body_frame(other.mesh, unit, "+x", "+z");
    EXPECT_NEAR(section_of(other, d, d).sigma.value, unit * unit * sigma, 1e-14 * unit * unit * sigma) << unit;
  }
}

TEST(Metamorphic, TurningTargetAndDirectionsTogetherChangesNothing) {
  std::mt19937_64 random(99);
  for (const Case& c : cases()) {
    const Eigen::Matrix3d turn = Eigen::Quaterniond::UnitRandom().toRotationMatrix();
    Case turned = c;
    for (Vec3& p : turned.target.mesh.positions) p = turn * p;
    measure_facets(turned.target.mesh);
    turned.di = (turn * c.di).normalized();
    turned.dr = c.dr == c.di ? turned.di : Vec3((turn * c.dr).normalized());
    expect_same(c, turned, 1.0, "turned");
  }
}

TEST(Metamorphic, SplittingFacetsChangesNothing) {
  std::mt19937_64 random(98);
  std::uniform_real_distribution<double> share(0.2, 0.4);
  for (const Case& c : cases()) {
    FacetMesh split;
    for (std::size_t k = 0; k < c.target.mesh.size(); ++k) {
      const auto [a, b, d] = c.target.mesh.corners(k);
      const double u = share(random), v = share(random);
      const Vec3 middle = a + u * (b - a) + v * (d - a);
      add_triangle(split, a, b, middle);
      add_triangle(split, b, d, middle);
      add_triangle(split, d, a, middle);
    }
    expect_same(c, {target_of(split, c.target.materials[0].brdf), c.di, c.dr}, 1.0, "split");
  }
}

TEST(Metamorphic, RenumberingFacetsAndVerticesChangesNothing) {
  std::mt19937_64 random(97);
  for (const Case& c : cases()) {
    const FacetMesh& mesh = c.target.mesh;
    std::vector<std::uint32_t> order(mesh.size());
    std::iota(order.begin(), order.end(), 0U);
    std::shuffle(order.begin(), order.end(), random);
    FacetMesh shuffled;
    for (const auto k : order) {
      const auto p = mesh.corners(k);
      const std::size_t first = random() % 3;
      add_triangle(shuffled, p[first], p[(first + 1) % 3], p[(first + 2) % 3]);
    }
    expect_same(c, {target_of(shuffled, c.target.materials[0].brdf), c.di, c.dr}, 1.0, "renumbered");
  }
}

TEST(Metamorphic, TwoCopiesOutOfEachOthersWayDoubleSigma) {
  for (const Case& c : cases()) {
    // Across both directions: neither copy stands before the other.
    const Vec3 across = c.di == c.dr ? c.di.unitOrthogonal() : c.di.cross(c.dr).normalized();
    FacetMesh two;
    append(two, c.target.mesh);
    append(two, c.target.mesh, 16.0 * across);
    expect_same(c, {target_of(two, c.target.materials[0].brdf), c.di, c.dr}, 2.0, "two copies");
  }
}

TEST(Metamorphic, ReversingEveryFacetChangesNothing) {
  for (const Case& c : cases()) {
    Case reversed = c;
    for (auto& f : reversed.target.mesh.facets) std::swap(f[1], f[2]);
    measure_facets(reversed.target.mesh);
    expect_same(c, reversed, 1.0, "reversed");
  }
}

TEST(Metamorphic, AReciprocalBrdfMakesSigmaReciprocalShadowsIncluded) {
  for (Case& c : cases()) {
    c.target.materials[0].brdf = lambert(0.7);
    const CrossSection there = section_of(c.target, c.di, c.dr), back = section_of(c.target, c.dr, c.di);
    EXPECT_NEAR(there.sigma.value, back.sigma.value, 1e-11 * std::max(there.sigma.value, 1e-12));
  }
}

TEST(Metamorphic, AClosedTargetTurnedInsideOutReturnsNothingFromItsFronts) {
  std::mt19937_64 random(96);
  Target inside_out = target_of(sphere(1.0, 8), lambert(1.0));
  for (auto& f : inside_out.mesh.facets) std::swap(f[1], f[2]);
  measure_facets(inside_out.mesh);
  inside_out.sides = Sides::front;
  const Vec3 d = random_direction(random);
  EXPECT_NEAR(section_of(inside_out, d, d).sigma.value, 0.0, 1e-13);
}

}  // namespace
}  // namespace lrcs
