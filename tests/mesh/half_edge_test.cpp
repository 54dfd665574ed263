#include "mesh/half_edge.h"

#include <gtest/gtest.h>

#include "made_meshes.h"
#include "mesh/diagnosis.h"

namespace lrcs {
namespace {

std::size_t boundary_edges(const HalfEdges& half) {
  std::size_t count = 0;
  for (const auto edge : half.mesh.edges()) count += half.mesh.is_boundary(edge) ? 1 : 0;
  return count;
}

TEST(HalfEdges, HoldEveryEdgeOfABoxOnce) {
  const HalfEdges half = half_edges(unit_box());
  EXPECT_EQ(half.mesh.n_vertices(), 8U);
  EXPECT_EQ(half.mesh.n_edges(), 18U);
  EXPECT_EQ(half.mesh.n_faces(), 12U);
  EXPECT_EQ(half.detached, 0U);
}

TEST(HalfEdges, KnowTheFacetOfEveryFace) {
  FacetMesh mesh = joined(mesh_of({{7, 7, 7}, {7, 7, 7}, {8, 8, 8}}, {{0, 1, 2}}), unit_box());
  const HalfEdges half = half_edges(mesh);
  ASSERT_EQ(half.facet.size(), half.mesh.n_faces());
  for (const auto face : half.mesh.faces()) {
    const auto corners = mesh.corners(half.facet[static_cast<std::size_t>(face.idx())]);
    Vec3 sum = Vec3::Zero();
    for (const auto vertex : face.vertices()) sum += Vec3(half.mesh.point(vertex).data());
    EXPECT_EQ(sum, corners[0] + corners[1] + corners[2]);
  }
  EXPECT_EQ(half.facet.front(), 1U);
}

TEST(HalfEdges, DetachTheThirdFacetAtAnEdgeWithoutAWordOnTheErrorStream) {
  const FacetMesh fins =
      mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  testing::internal::CaptureStderr();
  const HalfEdges half = half_edges(fins);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(half.detached, 1U);
  EXPECT_EQ(half.mesh.n_faces(), 3U);
}

TEST(HalfEdges, CountTheSameBoundaryAsTheDiagnosis) {
  FacetMesh open = unit_box();
  open.facets.resize(9);
  open = mesh_of(open.positions, open.facets);
  EXPECT_EQ(boundary_edges(half_edges(open)), diagnose(open).boundary_edges);
  EXPECT_EQ(boundary_edges(half_edges(unit_box())), 0U);
}

}  // namespace
}  // namespace lrcs
