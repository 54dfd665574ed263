#include "mesh/thorough_repair.h"

#include <gtest/gtest.h>

#include "made_meshes.h"
#include "mesh/diagnosis.h"

namespace lrcs {
namespace {

// An open box, its lid lying a little above it, one facet turned.
FacetMesh leaky_box(double gap) {
  FacetMesh mesh = unit_box();
  std::vector<Vec3> positions = mesh.positions;
  for (std::uint32_t k = 4; k < 8; ++k) positions.push_back(mesh.positions[k] + Vec3(0, 0, gap));
  Triangles facets = mesh.facets;
  for (const std::size_t k : {2U, 3U})
    for (std::uint32_t& corner : facets[k]) corner += 4;
  std::swap(facets[6][0], facets[6][1]);
  return mesh_of(positions, facets);
}

TEST(ThoroughRepair, ClosesWhatGapsKeepOpenAndTurnsItOutward) {
  FacetMesh mesh = reversed(leaky_box(1e-7));
  EXPECT_FALSE(diagnose(mesh).closed);
  const ThoroughRepairs repairs = repair_thoroughly(mesh, {1e-6});
  EXPECT_EQ(repairs.all.near_vertices, 4U);
  const Diagnosis d = diagnose(mesh);
  EXPECT_TRUE(d.closed);
  EXPECT_NEAR(d.volume, 1.0, 1e-6);
  EXPECT_EQ(d.flipped + d.boundary_edges, 0U);
  const ThoroughCounts again = repair_thoroughly(mesh, {1e-6}).all;
  EXPECT_EQ(again.flipped + again.near_vertices + again.degenerate + again.duplicate + again.t_junctions, 0U);
}

TEST(ThoroughRepair, MendsOnePartWhereAnotherCannotBeMended) {
  FacetMesh mesh = joined(reversed(unit_box()), moebius(8), true);
  const ThoroughRepairs repairs = repair_thoroughly(mesh, {});
  EXPECT_EQ(repairs.parts[0].flipped, 12U);
  EXPECT_EQ(repairs.parts[0].inward_shells, 1U);
  EXPECT_EQ(repairs.parts[1].flipped, 0U);
  EXPECT_TRUE(diagnose(mesh).parts[0].closed);
}

TEST(ThoroughRepair, GivesASheetOneWinding) {
  FacetMesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 3, 2}, {1, 4, 2}});
  EXPECT_EQ(repair_thoroughly(mesh, {}).all.flipped, 1U);
  for (const Vec3& normal : mesh.normals) EXPECT_EQ(normal, Vec3(0, 0, 1));
}

TEST(ThoroughRepair, DropsTheBackOfASheetOnlyIfAsked) {
  const FacetMesh sheet = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});
  FacetMesh kept = sheet, dropped = sheet;
  EXPECT_EQ(repair_thoroughly(kept, {}).all.opposite, 0U);
  EXPECT_EQ(kept.size(), 2U);
  EXPECT_EQ(repair_thoroughly(dropped, {.drop_opposite = true}).all.opposite, 1U);
  ASSERT_EQ(dropped.size(), 1U);
  EXPECT_EQ(dropped.normals[0], Vec3(0, 0, 1));
}

TEST(ThoroughRepair, FillsHolesOnlyIfAsked) {
  FacetMesh mesh = unit_box();
  mesh = mesh_of(mesh.positions, {mesh.facets.begin(), mesh.facets.end() - 2});
  EXPECT_EQ(repair_thoroughly(mesh, {}).all.holes_filled, 0U);
  EXPECT_EQ(repair_thoroughly(mesh, {.most_hole_edges = 4}).all.holes_filled, 1U);
  EXPECT_NEAR(diagnose(mesh).volume, 1.0, 1e-15);
}

}  // namespace
}  // namespace lrcs
