#include "mesh/normal_patches.h"

#include <gtest/gtest.h>

#include "base/compensated_sum.h"
#include "made_round_meshes.h"

namespace lrcs {
namespace {

using std::numbers::pi;

// Integral of (n.w)^2 over the patches, or over the flat facets.
double mean_square(const FacetMesh& mesh, const Vec3& w) {
  CompensatedSum sum;
  for (std::size_t k = 0; k < mesh.size(); ++k) {
    const std::uint32_t patch = mesh.curved.of.empty() ? CurvedFacets::flat : mesh.curved.of[k];
    if (patch == CurvedFacets::flat) {
      sum.add(mesh.areas[k] * std::pow(mesh.normals[k].dot(w), 2));
      continue;
    }
    const CurvedPatch& p = mesh.curved.patches[patch];
    for (std::size_t q = 0; q < PatchRule::size; ++q)
      sum.add(patch_rule().weight[q] * p.area[q] * std::pow(p.normal[q].dot(w), 2));
  }
  return sum.value();
}

double error_of_ball(int levels, double jitter) {
  FacetMesh ball = jittered_ball(levels, jitter, 5);
  EXPECT_EQ(curve_by_normals(ball, estimated_normals(ball, 60 * degree)).size(), 0U);
  return std::abs(mean_square(ball, Vec3(2, -1, 2) / 3.0) / (4.0 * pi / 3.0) - 1.0);
}

TEST(NormalPatches, ConvergeAtFourthOrderOnASphere) {
  for (const double jitter : {0.0, 0.15}) {
    const double coarse = error_of_ball(2, jitter), fine = error_of_ball(3, jitter);
    EXPECT_LT(fine, 1e-5);
    EXPECT_GT(std::log2(coarse / fine), 3.5);
  }
}

TEST(NormalPatches, LeaveNoGapsOnASphere) {
  FacetMesh ball = jittered_ball(2, 0.2, 9);
  curve_by_normals(ball, estimated_normals(ball, 60 * degree));
  Vec3 sum = Vec3::Zero();
  double area = 0.0;
  for (const CurvedPatch& p : ball.curved.patches)
    for (std::size_t q = 0; q < PatchRule::size; ++q) {
      sum += patch_rule().weight[q] * p.area[q] * p.normal[q];
      area += patch_rule().weight[q] * p.area[q];
    }
  EXPECT_LT(sum.norm(), 1e-14 * area);
}

TEST(NormalPatches, MakeACylinderOfItsRectanglesAndKeepItsCapsFlat) {
  FacetMesh tube = cylinder(48, 2.0);
  EXPECT_EQ(curve_by_normals(tube, estimated_normals(tube, 30 * degree)).size(), 0U);
  EXPECT_EQ(tube.curved.patches.size(), 96U);
  // Integral of (n.x)^2 over the side: pi h.
  EXPECT_NEAR(mean_square(tube, Vec3(1, 0, 0)) / (2.0 * pi), 1.0, 3e-6);
  FacetMesh flat = cylinder(48, 2.0);
  EXPECT_GT(std::abs(mean_square(flat, Vec3(1, 0, 0)) / (2.0 * pi) - 1.0), 5e-4);
}

TEST(NormalPatches, LeaveAMeshOfCreasesAsItIs) {
  FacetMesh mesh = unit_box();
  EXPECT_EQ(curve_by_normals(mesh, estimated_normals(mesh, 45 * degree)).size(), 0U);
  EXPECT_TRUE(mesh.curved.of.empty());
}

TEST(NormalPatches, AreFiniteOnSidesTheSquaresOfWhichAreNot) {
  for (const double side : {1e-170, 1e-300}) {
    FacetMesh mesh = mesh_of({{0, 0, 0}, {side, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    // Those of an arc along its long sides.
    curve_by_normals(mesh, CornerNormals(1, {Vec3(0, -0.28, 0.96), Vec3(0, -0.28, 0.96), Vec3(0, 0.28, 0.96)}));
    ASSERT_EQ(mesh.curved.patches.size(), 1U);
    for (std::size_t p = 0; p < PatchRule::size; ++p) {
      EXPECT_TRUE(mesh.curved.patches[0].normal[p].allFinite());
      EXPECT_LT(mesh.curved.patches[0].area[p],
                1e-3);  // of its long sides squared: the model bends a needle's middle apart
    }
  }
}

TEST(NormalPatches, SayWhichNormalsAreOfNoUse) {
  FacetMesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 3, 2}});
  CornerNormals normals(2, {Vec3(0, 0, 1), Vec3(0, 0.6, 0.8), Vec3(0, 0, 1)});
  normals[1][2] = Vec3(0, 0, -1);
  EXPECT_EQ(curve_by_normals(mesh, normals).size(), 1U);
  EXPECT_NE(mesh.curved.of[0], CurvedFacets::flat);
  EXPECT_EQ(mesh.curved.of[1], CurvedFacets::flat);
}

}  // namespace
}  // namespace lrcs
