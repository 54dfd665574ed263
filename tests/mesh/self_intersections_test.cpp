#include "mesh/self_intersections.h"

#include <gtest/gtest.h>

#include "made_meshes.h"
#include "mesh/repair.h"

namespace lrcs {
namespace {

std::size_t pairs(FacetMesh mesh) {
  repair(mesh);
  const SelfIntersections found = self_intersections(mesh);
  EXPECT_TRUE(found.complete);
  return found.pairs;
}

// A polygon whose sides all cross, as a fan.
FacetMesh star(std::uint32_t corners) {
  std::vector<Vec3> positions;
  Triangles facets;
  for (std::uint32_t k = 0; k < corners; ++k) {
    const double turn = 2.0 * std::numbers::pi * k * (corners / 2) / corners;
    positions.emplace_back(std::cos(turn), std::sin(turn), 0.0);
    if (k >= 2) facets.push_back({0, k - 1, k});
  }
  return mesh_of(positions, facets);
}

TEST(SelfIntersections, AreNoneInABoxAndInAMoebiusBand) {
  EXPECT_EQ(pairs(unit_box()), 0U);
  EXPECT_EQ(pairs(moebius(20)), 0U);
}

TEST(SelfIntersections, CountATriangleThatPiercesAnother) {
  EXPECT_EQ(pairs(mesh_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {9, 9, 1}}, {{0, 1, 2}, {3, 4, 5}})),
            1U);
}

TEST(SelfIntersections, CountFacetsOfACommonVertexOnlyWhereTheyMeetBeyondIt) {
  const std::vector<Vec3> positions{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {-1, -1, 1}, {-1, -1, -1}};
  EXPECT_EQ(pairs(mesh_of(positions, {{0, 1, 2}, {0, 3, 4}})), 1U);
  EXPECT_EQ(pairs(mesh_of(positions, {{0, 1, 2}, {0, 5, 6}})), 0U);
}

TEST(SelfIntersections, CountFacetsOfACommonEdgeOnlyWhereTheyLieOnEachOther) {
  const std::vector<Vec3> positions{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}, {1, -1, 0}, {1, 1, 1e-12}};
  EXPECT_EQ(pairs(mesh_of(positions, {{0, 1, 2}, {0, 1, 3}})), 1U);
  EXPECT_EQ(pairs(mesh_of(positions, {{0, 1, 2}, {0, 1, 4}})), 0U);
  EXPECT_EQ(pairs(mesh_of(positions, {{0, 1, 2}, {0, 1, 5}})), 0U);
}

TEST(SelfIntersections, DoNotCountTheTwoSidesOfASheet) {
  EXPECT_EQ(pairs(mesh_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}, {0, 2, 1}})), 0U);
}

TEST(SelfIntersections, CountThePairsOfTwoBoxesPutIntoEachOther) {
  // The corner box cuts three sides of the unit box, and three of its own sides are cut.
  EXPECT_GT(pairs(joined(unit_box(), box({0.5, 0.5, 0.5}, {2, 2, 2}))), 0U);
  EXPECT_EQ(pairs(joined(unit_box(), box({1.5, 1.5, 1.5}, {2, 2, 2}))), 0U);
  // A needle through two opposite sides, off their diagonals: each of its four long sides' two facets may meet either.
  EXPECT_EQ(pairs(joined(unit_box(), mesh_of({{0.2, 0.3, -1}, {0.2, 0.3, 2}, {0.2, 0.31, 2}}, {{0, 1, 2}}))), 2U);
}

TEST(SelfIntersections, StopAtTheLimitOfTestsAndSayThatTheyDid) {
  const FacetMesh mesh = star(101);
  const SelfIntersections all = self_intersections(mesh);
  EXPECT_TRUE(all.complete);
  const SelfIntersections some = self_intersections(mesh, 1000);
  EXPECT_FALSE(some.complete);
  EXPECT_GT(some.pairs, 0U);
  EXPECT_LT(some.pairs, all.pairs);
  EXPECT_EQ(some.pairs, self_intersections(mesh, 1000).pairs);
}

TEST(SelfIntersections, AnswerInSecondsForAPolygonThatCrossesItselfEverywhere) {
  const SelfIntersections found = self_intersections(star(20'001));
  EXPECT_FALSE(found.complete);
  EXPECT_GT(found.pairs, 1'000'000U);
}

}  // namespace
}  // namespace lrcs
