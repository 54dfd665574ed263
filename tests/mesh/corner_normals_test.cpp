#include "mesh/corner_normals.h"

#include <gtest/gtest.h>

#include "made_meshes.h"
#include "made_round_meshes.h"

namespace lrcs {
namespace {

TEST(EstimatedNormals, AreExactOnASphereOfUnequalFacets) {
  const FacetMesh ball = jittered_ball(1, 0.3, 11);
  const CornerNormals normals = estimated_normals(ball, 89 * degree);
  for (std::size_t k = 0; k < ball.size(); ++k)
    for (int c = 0; c < 3; ++c) EXPECT_LT((normals[k][c] - ball.corners(k)[c]).norm(), 1e-13);
}

TEST(EstimatedNormals, AreExactOnACylinderAndBreakAtItsRims) {
  const FacetMesh tube = cylinder(12, 3);
  const CornerNormals normals = estimated_normals(tube, 31 * degree);
  for (std::size_t k = 0; k < tube.size(); ++k)
    for (int c = 0; c < 3; ++c) {
      const Vec3 p = tube.corners(k)[c];
      const bool cap = std::abs(tube.normals[k].z()) > 0.5;
      const Vec3 expected = cap ? tube.normals[k] : Vec3(p.x(), p.y(), 0.0);
      EXPECT_LT((normals[k][c] - expected).norm(), 1e-14);
    }
}

TEST(EstimatedNormals, AreThoseOfTheFacetsBelowTheCreaseAngle) {
  for (const FacetMesh& mesh : {cylinder(12, 3), unit_box()}) {
    const CornerNormals normals = estimated_normals(mesh, 29 * degree);
    for (std::size_t k = 0; k < mesh.size(); ++k)
      for (int c = 0; c < 3; ++c) EXPECT_LT((normals[k][c] - mesh.normals[k]).norm(), 1e-15);
  }
}

TEST(EstimatedNormals, TakeEdgesOfMixedWindingsForCreases) {
  FacetMesh fold = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0.1}, {0, -1, 0.1}}, {{0, 1, 2}, {0, 1, 3}});
  const CornerNormals normals = estimated_normals(fold, 30 * degree);
  for (std::size_t k = 0; k < 2; ++k)
    for (int c = 0; c < 3; ++c) EXPECT_LT((normals[k][c] - fold.normals[k]).norm(), 1e-15);
}

}  // namespace
}  // namespace lrcs
