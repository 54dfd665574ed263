#include "mesh/holes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "made_meshes.h"
#include "mesh/diagnosis.h"

namespace lrcs {
namespace {

// Without the facets of these numbers.
FacetMesh without(const FacetMesh& mesh, const std::vector<std::size_t>& left_out) {
  Triangles facets;
  for (std::size_t k = 0; k < mesh.size(); ++k)
    if (std::find(left_out.begin(), left_out.end(), k) == left_out.end()) facets.push_back(mesh.facets[k]);
  return mesh_of(mesh.positions, facets);
}

TEST(Holes, AreNoneInAClosedMesh) {
  EXPECT_TRUE(holes(unit_box()).empty());
}

TEST(Holes, OfABoxWithoutLidAndFloorAreTwo) {
  const auto found = holes(without(unit_box(), {0, 1, 2, 3}));
  ASSERT_EQ(found.size(), 2U);
  for (const Hole& hole : found) {
    EXPECT_TRUE(hole.is_loop);
    EXPECT_EQ(hole.rim.size(), 4U);
  }
}

TEST(Holes, ThatMeetInAVertexAreTwo) {
  // Two opposite corners of a fan of eight facets round a vertex are missing: both rims pass through it.
  std::vector<Vec3> positions{{0, 0, 0}};
  Triangles facets;
  for (std::uint32_t k = 0; k < 8; ++k) {
    positions.emplace_back(std::cos(0.25 * std::numbers::pi * k), std::sin(0.25 * std::numbers::pi * k), 0.0);
    facets.push_back({0, 1 + k, 1 + (k + 1) % 8});
  }
  const auto found = holes(without(mesh_of(positions, facets), {0, 4}));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].rim.size() + found[1].rim.size(), 10U);
  EXPECT_TRUE(found[0].is_loop && found[1].is_loop);
}

TEST(Holes, OfMixedWindingsAreFoundAllTheSame) {
  FacetMesh mesh = without(unit_box(), {0, 1});
  for (const std::size_t k : {3U, 5U, 8U}) std::swap(mesh.facets[k][0], mesh.facets[k][1]);
  const auto found = holes(mesh);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].rim.size(), 4U);
}

TEST(FillHoles, ClosesABoxWithItsWinding) {
  FacetMesh mesh = without(unit_box(), {0, 1, 7});
  EXPECT_EQ(fill_holes(mesh, 3), 1U);
  EXPECT_EQ(fill_holes(mesh, 4), 1U);
  EXPECT_EQ(fill_holes(mesh, 1000), 0U);
  EXPECT_EQ(mesh.size(), 12U);
  EXPECT_EQ(mesh.normals.size(), 12U);
  const Diagnosis d = diagnose(mesh);
  EXPECT_TRUE(d.closed);
  EXPECT_EQ(d.flipped, 0U);
  EXPECT_NEAR(d.volume, 1.0, 1e-15);
}

TEST(FillHoles, LeavesThePartsThatShareAnEdgeAlone) {
  // Every side of the box is a part: no part is closed, the whole is.
  FacetMesh mesh = unit_box();
  for (std::uint32_t k = 0; k < 12; ++k) mesh.part.of[k] = k / 2;
  mesh.part.names = {"a", "b", "c", "d", "e", "f"};
  EXPECT_EQ(fill_holes(mesh, 1000), 0U);
}

}  // namespace
}  // namespace lrcs
