#include "lrcs/hull_facets.h"

#include <gtest/gtest.h>

#include <random>

#include "lrcs/plane_side.h"
#include "lrcs/surface.h"
#include "tests/lrcs/test_targets.h"

namespace lrcs {
namespace {

bool is_in_front(const Occluders& occluders, std::uint32_t facet, std::uint32_t vertex, int facing) {
  const auto& at = occluders.positions;
  const auto& [a, b, c] = occluders.facets[facet];
  return facing * plane_side(at[a], at[b], at[c], occluders.cross[facet], at[vertex]) > 0;
}

bool any_in_front(const Surface& surface, std::uint32_t facet, int facing) {
  for (std::uint32_t v = 0; v < surface.occluders.positions.size(); ++v)
    if (is_in_front(surface.occluders, facet, v, facing)) return true;
  return false;
}

bool any_of_its_part_in_front(const Surface& surface, std::uint32_t facet, int facing) {
  for (const std::uint32_t v : surface.parts.vertices(surface.parts.of(facet)))
    if (is_in_front(surface.occluders, facet, v, facing)) return true;
  return false;
}

// What is said against every vertex, one by one. All of it is told of small targets.
void expect_exact(const FacetMesh& mesh) {
  const Surface surface(mesh);
  for (std::uint32_t f = 0; f < surface.occluders.size(); ++f)
    for (const int facing : {1, -1}) {
      const bool asked = !surface.contacts.any(f) && (facing > 0 || surface.of_solid[f] == 0);
      EXPECT_EQ(surface.hull.nothing_before(f, facing), asked && !any_in_front(surface, f, facing)) << f;
      EXPECT_EQ(surface.hull.nothing_of_its_part_before(f, facing),
                asked && !any_of_its_part_in_front(surface, f, facing))
          << f;
    }
}

std::size_t hull_size(const FacetMesh& mesh) {
  return Surface(mesh).hull.size();
}

TEST(HullFacets, AreAllOfAConvexBody) {
  EXPECT_EQ(hull_size(box({0, 0, 0}, {1, 2, 3})), 12U);
  EXPECT_EQ(hull_size(icosphere(2)), 320U);
}

TEST(HullFacets, AreTheOuterFacesOfTwoBoxesSideBySide) {
  FacetMesh mesh = box({0, 0, 0}, {1, 1, 1});
  append(mesh, box({2, 0, 0}, {3, 1, 1}));
  // Each but the two facets of the gap.
  EXPECT_EQ(hull_size(mesh), 20U);
  const Surface surface(mesh);
  std::size_t of_part_only = 0;
  for (std::uint32_t f = 0; f < 24; ++f) of_part_only += surface.hull.is_on_hull_of_its_part_only(f) ? 1 : 0;
  EXPECT_EQ(of_part_only, 4U);
}

TEST(HullFacets, AreNoneOfWhatIsInside) {
  FacetMesh mesh = box({0, 0, 0}, {4, 4, 4});
  append(mesh, box({1, 1, 1}, {2, 2, 2}));
  EXPECT_EQ(hull_size(mesh), 12U);
}

TEST(HullFacets, OfAnOpenSheetMayBeSeenFromBothSides) {
  FacetMesh mesh;
  add_plate(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const Surface surface(mesh);
  for (const std::uint32_t f : {0U, 1U}) {
    EXPECT_TRUE(surface.hull.nothing_before(f, 1));
    EXPECT_TRUE(surface.hull.nothing_before(f, -1));
  }
}

TEST(HullFacets, LeaveOutWhatOthersLieOn) {
  FacetMesh mesh = box({0, 0, 0}, {1, 1, 1});
  add_plate(mesh, {0.25, 0.25, 1}, {0.5, 0, 0}, {0, 0.5, 0});
  // The two facets of the top, and the plate on it.
  EXPECT_EQ(hull_size(mesh), 10U);
  FacetMesh twice = box({0, 0, 0}, {1, 1, 1});
  append(twice, box({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(hull_size(twice), 0U);
}

TEST(HullFacets, ATinyBumpOnAFaceTakesItOffTheHull) {
  FacetMesh mesh = box({0, 0, 0}, {1, 1, 1});
  const double above = std::nextafter(1.0, 2.0);
  add_triangle(mesh, {0.3, 0.4, above}, {0.5, 0.4, above}, {0.4, 0.6, above});
  const Surface surface(mesh);
  for (std::uint32_t f = 0; f < surface.occluders.size(); ++f)
    EXPECT_FALSE(surface.occluders.cross[f].z() > 0.5 && surface.hull.nothing_before(f, 1)) << f;
  expect_exact(mesh);
}

TEST(HullFacets, AreExactOnSoupsAndOnBoxesThatTouch) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    expect_exact(random_soup(random, 60));
    FacetMesh boxes;
    std::uniform_int_distribution<int> whole(0, 5);
    for (int k = 0; k < 6; ++k) {
      const Vec3 low(whole(random), whole(random), whole(random));
      add_box(boxes, low, low + Vec3(1 + whole(random), 1 + whole(random), 1 + whole(random)));
    }
    expect_exact(boxes);
    const Eigen::AngleAxisd turn(1.0, random_direction(random));
    for (Vec3& p : boxes.positions) p = turn * p;
    expect_exact(boxes);
  }
}

TEST(HullFacets, AreExactOnCurvedBodiesFarFromTheOrigin) {
  for (const double far : {0.0, 1e3, 1e7}) {
    FacetMesh mesh = sphere(1.0, 12);
    append(mesh, icosphere(2), {1.5, 0.2, 0.1});
    for (Vec3& p : mesh.positions) p += Vec3(far, -far, far);
    expect_exact(mesh);
  }
}

}  // namespace
}  // namespace lrcs
