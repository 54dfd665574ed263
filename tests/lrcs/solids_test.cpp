#include "lrcs/solids.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/lrcs/test_targets.h"

namespace lrcs {
namespace {

// By the mesh's facet numbers; facets of area zero are none of a solid.
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

FacetMesh box(const Vec3& low, const Vec3& high) {
  FacetMesh mesh;
  add_box(mesh, low, high);
  return mesh;
}

FacetMesh reversed(FacetMesh mesh) {
  for (auto& f : mesh.facets) std::swap(f[1], f[2]);
  return mesh;
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

TEST(SolidFacets, OfBodiesThatShareAnEdgeOrLieFaceToFace) {
  FacetMesh edge_to_edge = box({0, 0, 0}, {1, 1, 1});
  append(edge_to_edge, box({1, 1, 0}, {2, 2, 1}));
  EXPECT_EQ(solid_count(edge_to_edge), 24U);
  FacetMesh face_to_face = box({0, 0, 0}, {1, 1, 1});
  append(face_to_face, box({1, 0, 0}, {2, 1, 1}));
  EXPECT_EQ(solid_count(face_to_face), 24U);
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

TEST(SolidFacets, AreClosedByFacetsOfAreaZero) {
  // The top of a box is cut in four at a point on one of its edges; a facet of area zero joins the halves of that edge.
  FacetMesh mesh;
  const Vec3 a(0, 0, 1), b(2, 0, 1), c(2, 1, 1), d(0, 1, 1), middle(1, 0, 1);
  add_box(mesh, {0, 0, 0}, {2, 1, 1});
  // add_box's second plate, facets 2 and 3, is the top.
  mesh.facets.erase(mesh.facets.begin() + 2, mesh.facets.begin() + 4);
  add_triangle(mesh, a, middle, d);
  add_triangle(mesh, middle, c, d);
  add_triangle(mesh, middle, b, c);
  EXPECT_EQ(solid_count(mesh), 0U);
  add_triangle(mesh, a, b, middle);
  EXPECT_EQ(solid_count(mesh), mesh.size() - 1);
}

}  // namespace
}  // namespace lrcs
