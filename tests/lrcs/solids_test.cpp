#include "lrcs/solids.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/lrcs/test_targets.h"

namespace lrcs {
namespace {

// By the mesh's facet numbers.
std::vector<std::uint8_t> solid_of(const FacetMesh& mesh) {
  const Occluders occluders(mesh);
  const FacetTree tree(occluders);
  const OccluderEdges edges(occluders);
  const Contacts contacts(occluders, tree, edges);
  const auto solid = solid_facets(occluders, tree, edges, contacts);
  std::vector<std::uint8_t> by_facet(mesh.size(), 0);
  for (std::uint32_t f = 0; f < occluders.size(); ++f) by_facet[occluders.original[f]] = solid[f];
  return by_facet;
}

std::size_t solid_count(const FacetMesh& mesh) {
  const auto solid = solid_of(mesh);
  return static_cast<std::size_t>(std::count(solid.begin(), solid.end(), 1));
}

TEST(SolidFacets, AreThoseOfAClosedOutwardSurface) {
  EXPECT_EQ(solid_count(box({0, 0, 0}, {1, 1, 1})), 12U);
  EXPECT_EQ(solid_count(sphere(1.0, 8)), sphere(1.0, 8).size());
}

TEST(SolidFacets, AreNoneOfAnOpenOrInwardSurface) {
  FacetMesh open = box({0, 0, 0}, {1, 1, 1});
  open.facets.pop_back();
  EXPECT_EQ(solid_count(open), 0U);
  EXPECT_EQ(solid_count(reversed(box({0, 0, 0}, {1, 1, 1}))), 0U);
  FacetMesh one_turned = box({0, 0, 0}, {1, 1, 1});
  std::swap(one_turned.facets[3][1], one_turned.facets[3][2]);
  EXPECT_EQ(solid_count(one_turned), 0U);
}

TEST(SolidFacets, LeaveOutACavity) {
  FacetMesh mesh = box({0, 0, 0}, {4, 4, 4});
  append(mesh, reversed(box({1, 1, 1}, {2, 2, 2})));
  const auto solid = solid_of(mesh);
  EXPECT_EQ(std::count(solid.begin(), solid.begin() + 12, 1), 12);
  EXPECT_EQ(std::count(solid.begin() + 12, solid.end(), 1), 0);
}

TEST(SolidFacets, OfBodiesThatShareAnEdgeOrTouch) {
  FacetMesh edge_to_edge = box({0, 0, 0}, {1, 1, 1});
  append(edge_to_edge, box({1, 1, 0}, {2, 2, 1}));
  EXPECT_EQ(solid_count(edge_to_edge), 24U);
  FacetMesh touching = box({0, 0, 0}, {1, 1, 1});
  append(touching, box({1, 0.25, 0.25}, {2, 0.75, 0.75}));
  EXPECT_EQ(solid_count(touching), 24U);
}

// With common vertices, bodies face to face are one piece, which meets itself: left out, to be on the safe side.
TEST(SolidFacets, LeaveOutBodiesFaceToFaceWithCommonVertices) {
  FacetMesh mesh = box({0, 0, 0}, {1, 1, 1});
  append(mesh, box({1, 0, 0}, {2, 1, 1}));
  EXPECT_EQ(solid_count(mesh), 0U);
}

TEST(SolidFacets, OfBodiesThatPassThroughEachOtherButNotThroughThemselves) {
  FacetMesh crossing = box({0, 0, 0}, {2, 2, 2});
  append(crossing, box({1, 1, 1}, {3, 3, 3}));
  EXPECT_EQ(solid_count(crossing), 24U);
  // A sphere one side of which is pushed out through the other: there it winds backward.
  FacetMesh pierced = sphere(1.0, 12);
  for (Vec3& p : pierced.positions)
    if (p.x() > 0.8) p.x() -= 3.0;
  EXPECT_EQ(solid_count(pierced), 0U);
}

// A prism over a figure of eight. Its strands cross along a line that is one edge of the one and two of the other, so
// that no facet passes through another one's plane there; behind the crossing it winds backward.
TEST(SolidFacets, AreNotThoseOfASurfaceThatCrossesItselfAlongEdges) {
  FacetMesh mesh;
  for (const double z : {0.0, 1.0})
    for (const auto& [x, y] : {std::pair(0.0, 0.0), {2.0, 0.0}, {2.0, 1.0}, {1.0, 0.0}, {0.0, -1.0}})
      add_vertex(mesh, {x, y, z});
  const std::uint32_t middle = add_vertex(mesh, {1, 0, 0.5});
  for (const auto& [a, b] : {std::pair(0U, 3U), {3U, 1U}, {1U, 2U}, {4U, 0U}}) {
    add_facet(mesh, a, b, b + 5);
    add_facet(mesh, a, b + 5, a + 5);
  }
  const std::vector<std::array<std::uint32_t, 3>> split{{2, 3, middle}, {2, middle, 8}, {2, 8, 7},
                                                        {4, 9, 8},      {4, 8, middle}, {4, middle, 3}};
  for (const auto& f : split) add_facet(mesh, f[0], f[1], f[2]);
  for (const auto& f : {std::array{0U, 3U, 4U}, std::array{3U, 1U, 2U}}) {
    add_facet(mesh, f[0], f[2], f[1]);
    add_facet(mesh, f[0] + 5, f[1] + 5, f[2] + 5);
  }
  EXPECT_EQ(solid_count(mesh), 0U);
  EXPECT_EQ(solid_count(reversed(mesh)), 0U);
}

}  // namespace
}  // namespace lrcs
