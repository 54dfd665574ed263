#include "mesh/repair.h"

#include <gtest/gtest.h>

#include "made_meshes.h"

namespace lrcs {
namespace {

double volume(const FacetMesh& mesh) {
  double sum = 0.0;
  for (std::size_t k = 0; k < mesh.size(); ++k) {
    const auto [a, b, c] = mesh.corners(k);
    sum += a.dot(b.cross(c)) / 6.0;
  }
  return sum;
}

// Every facet with three vertices of its own, as in an STL file.
FacetMesh soup_of(const FacetMesh& mesh) {
  FacetMesh soup = mesh;
  soup.positions.clear();
  for (std::uint32_t k = 0; k < mesh.size(); ++k) {
    for (const Vec3& corner : mesh.corners(k)) soup.positions.push_back(corner);
    soup.facets[k] = {3 * k, 3 * k + 1, 3 * k + 2};
  }
  return soup;
}

TEST(Repair, WeldsVerticesOfEqualPosition) {
  FacetMesh mesh = soup_of(unit_box());
  EXPECT_EQ(repair(mesh).welded_vertices, 28U);
  EXPECT_EQ(mesh.positions.size(), 8U);
  EXPECT_NEAR(volume(mesh), 1.0, 1e-15);
}

TEST(Repair, TakesZeroAndNegativeZeroForTheSamePlace) {
  FacetMesh mesh = mesh_of({{0.0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, -0.0}, {1, 0, 1}}, {{0, 1, 2}, {3, 4, 1}});
  EXPECT_EQ(repair(mesh).welded_vertices, 1U);
}

TEST(Repair, DropsFacetsOfNoAreaAndOnlyThose) {
  FacetMesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {0.5, 1e-300, 0}, {0.5, 1e-90, 0}, {1, 0, 0}},
                           {{0, 1, 2}, {0, 1, 3}, {0, 0, 1}, {1, 6, 2}, {0, 1, 5}});
  EXPECT_EQ(repair(mesh).degenerate, 3U);
  EXPECT_EQ(mesh.source_facet, (std::vector<std::uint32_t>{0, 4}));
}

TEST(Repair, DropsARepeatedFacetAndKeepsTheBackOfASheet) {
  FacetMesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {1, 2, 0}, {0, 2, 1}, {2, 1, 0}});
  const RepairCounts counts = repair(mesh);
  EXPECT_EQ(counts.duplicate, 2U);
  EXPECT_EQ(counts.flipped, 0U);
  EXPECT_EQ(mesh.source_facet, (std::vector<std::uint32_t>{0, 2}));
}

TEST(Repair, TurnsAFlippedFacetOfABoxRound) {
  FacetMesh mesh = unit_box();
  std::swap(mesh.facets[5][0], mesh.facets[5][2]);
  EXPECT_EQ(repair(mesh).flipped, 1U);
  EXPECT_NEAR(volume(mesh), 1.0, 1e-15);
}

TEST(Repair, TurnsAnInwardBoxOutwardAndOnlyThat) {
  FacetMesh mesh = joined(unit_box(), reversed(box({2, 2, 2}, {3, 3, 3})));
  EXPECT_EQ(repair(mesh).flipped, 12U);
  EXPECT_NEAR(volume(mesh), 2.0, 1e-14);
}

TEST(Repair, KeepsACavityInwardAndABodyInsideAnotherOutward) {
  FacetMesh hollow = joined(box({0, 0, 0}, {3, 3, 3}), reversed(box({1, 1, 1}, {2, 2, 2})));
  EXPECT_EQ(repair(hollow).flipped, 0U);
  EXPECT_NEAR(volume(hollow), 26.0, 1e-13);
  FacetMesh cargo = joined(box({0, 0, 0}, {3, 3, 3}), box({1, 1, 1}, {2, 2, 2}));
  EXPECT_EQ(repair(cargo).flipped, 0U);
}

TEST(Repair, TurnsTheOutsideOfAHollowBoxAndNotItsCavity) {
  FacetMesh mesh = joined(reversed(box({0, 0, 0}, {3, 3, 3})), reversed(box({1, 1, 1}, {2, 2, 2})));
  EXPECT_EQ(repair(mesh).flipped, 12U);
  EXPECT_NEAR(volume(mesh), 26.0, 1e-13);
}

TEST(Repair, IsNotHeldUpByAnOpenOrAOneSidedPiece) {
  FacetMesh open = box({5, 0, 0}, {6, 1, 1});
  open.facets.pop_back();
  open = mesh_of(open.positions, open.facets);
  FacetMesh mesh = joined(joined(open, moebius(12)), reversed(box({8, 0, 0}, {9, 1, 1})));
  const FacetMesh before = mesh;
  EXPECT_EQ(repair(mesh).flipped, 12U);
  for (std::size_t k = 0; k < 11 + 24; ++k) EXPECT_EQ(mesh.facets[k], before.facets[k]);
}

TEST(Repair, TurnsBothOfTwoInwardBoxesThatShareAnEdge) {
  FacetMesh mesh = joined(reversed(unit_box()), reversed(box({1, 1, 0}, {2, 2, 1})));
  EXPECT_EQ(repair(mesh).flipped, 24U);
  EXPECT_NEAR(volume(mesh), 2.0, 1e-14);
}

TEST(Repair, TurnsAnInwardPartThatTouchesItsNeighbourFaceToFace) {
  FacetMesh mesh = joined(unit_box(), reversed(box({1, 0, 0}, {2, 1, 1})), true);
  EXPECT_EQ(repair(mesh).flipped, 12U);
  EXPECT_NEAR(volume(mesh), 2.0, 1e-14);
}

TEST(Repair, TurnsABodyWhosePanelsAreParts) {
  FacetMesh mesh = reversed(unit_box());
  mesh.part.names = {"lower", "upper"};
  for (std::size_t k = 6; k < 12; ++k) mesh.part.of[k] = 1;
  EXPECT_EQ(repair(mesh).flipped, 12U);
  EXPECT_NEAR(volume(mesh), 1.0, 1e-15);
}

TEST(Repair, FindsABodyClosedThatOnlyACollinearFacetCloses) {
  // The lower front edge 0-1 of an inward box is cut by a vertex at its middle in one of its two facets.
  FacetMesh mesh = reversed(unit_box());
  mesh.positions.emplace_back(0.5, 0, 0);
  Triangles facets;
  for (const auto& f : mesh.facets) {
    if (f == std::array<std::uint32_t, 3>{0, 4, 1}) {
      facets.push_back({0, 4, 8});
      facets.push_back({8, 4, 1});
    } else {
      facets.push_back(f);
    }
  }
  facets.push_back({0, 8, 1});
  mesh = mesh_of(mesh.positions, facets);
  const RepairCounts counts = repair(mesh);
  EXPECT_EQ(counts.degenerate, 1U);
  EXPECT_EQ(counts.flipped, 13U);
  EXPECT_NEAR(volume(mesh), 1.0, 1e-15);
}

TEST(Repair, CarriesWhatBelongsToAFacetAlong) {
  FacetMesh mesh = joined(mesh_of({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}}, {{0, 1, 2}}), unit_box(), true);
  mesh.file_material.names = {"", "steel"};
  mesh.file_material.of[12] = 1;
  repair(mesh);
  EXPECT_EQ(mesh.size(), 12U);
  EXPECT_EQ(mesh.part.of, std::vector<std::uint32_t>(12, 1));
  EXPECT_EQ(mesh.file_material.of.back(), 1U);
  EXPECT_EQ(mesh.source_facet.front(), 1U);
  EXPECT_EQ(mesh.areas.size(), 12U);
}

TEST(Repair, DoesNothingTheSecondTime) {
  FacetMesh mesh = joined(soup_of(reversed(unit_box())), moebius(10));
  repair(mesh);
  const FacetMesh before = mesh;
  const RepairCounts counts = repair(mesh);
  EXPECT_EQ(counts.welded_vertices + counts.degenerate + counts.duplicate + counts.flipped, 0U);
  EXPECT_EQ(mesh.facets, before.facets);
}

TEST(Repair, LeavesNothingOfAMeshThatIsAllDegenerate) {
  FacetMesh mesh = mesh_of({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}, {0, 0, 0}});
  EXPECT_EQ(repair(mesh).degenerate, 2U);
  EXPECT_EQ(mesh.size(), 0U);
}

}  // namespace
}  // namespace lrcs
