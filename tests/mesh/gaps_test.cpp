#include "mesh/gaps.h"

#include <gtest/gtest.h>

#include "made_meshes.h"
#include "mesh/diagnosis.h"
#include "mesh/repair.h"

namespace lrcs {
namespace {

// A square [0, 1]^2 of two facets beside a strip of `pieces` squares below it, all along the square's lower edge, which
// has no vertices there. The strip lies `gap` below the square.
FacetMesh square_on_strip(std::uint32_t pieces, double gap) {
  std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  Triangles facets{{0, 1, 2}, {0, 2, 3}};
  for (std::uint32_t k = 0; k <= pieces; ++k) {
    const double x = static_cast<double>(k) / pieces;
    positions.emplace_back(x, -gap, 0.0);
    positions.emplace_back(x, -1.0, 0.0);
  }
  for (std::uint32_t k = 0; k < pieces; ++k) {
    const std::uint32_t a = 4 + 2 * k;
    facets.push_back({a, a + 1, a + 3});
    facets.push_back({a, a + 3, a + 2});
  }
  return mesh_of(positions, facets);
}

FacetMesh repaired(FacetMesh mesh) {
  repair(mesh);
  return mesh;
}

double area(const FacetMesh& mesh) {
  double sum = 0.0;
  for (const double a : mesh.areas) sum += a;
  return sum;
}

TEST(Gaps, AreNoneInABoxAndAtTheOutlineOfASheet) {
  for (const FacetMesh& mesh : {unit_box(), mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}})}) {
    const Gaps gaps = find_gaps(mesh, 0.01);
    EXPECT_TRUE(gaps.complete);
    EXPECT_EQ(gaps.near_vertices.size() + gaps.t_junctions.size(), 0U);
  }
}

TEST(Gaps, AreVerticesExactlyOnAnOpenEdgeWithoutTolerance) {
  const Gaps gaps = find_gaps(repaired(square_on_strip(4, 0.0)), 0.0);
  ASSERT_EQ(gaps.t_junctions.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(gaps.t_junctions[k].facet, 0U);
    EXPECT_EQ(gaps.t_junctions[k].edge, 0U);
    EXPECT_EQ(gaps.t_junctions[k].along, 0.25 * static_cast<double>(k + 1));
  }
  EXPECT_TRUE(find_gaps(square_on_strip(4, 1e-300), 0.0).t_junctions.empty());
}

TEST(Gaps, AreTJunctionsAndNearVerticesWithinTheToleranceOnly) {
  const FacetMesh mesh = square_on_strip(4, 1e-4);
  const Gaps within = find_gaps(mesh, 1.01e-4);
  EXPECT_EQ(within.t_junctions.size(), 3U);
  EXPECT_EQ(within.near_vertices, (std::vector<std::pair<std::uint32_t, std::uint32_t>>{{0, 4}, {1, 12}}));
  const Gaps beyond = find_gaps(mesh, 0.99e-4);
  EXPECT_EQ(beyond.t_junctions.size() + beyond.near_vertices.size(), 0U);
}

TEST(CloseGaps, JoinsTheSurfaceAndMovesItByNoMoreThanTheTolerance) {
  for (const double gap : {0.0, 1e-5}) {
    FacetMesh mesh = repaired(square_on_strip(7, gap));
    const GapCounts counts = close_gaps(mesh, gap);
    EXPECT_TRUE(counts.complete);
    EXPECT_EQ(counts.t_junctions, 6U);
    EXPECT_EQ(counts.welded, gap > 0.0 ? 2U : 0U);
    EXPECT_NEAR(area(mesh), 2.0, 1e-14);
    const Diagnosis d = diagnose(mesh);
    EXPECT_EQ(d.holes, 1U);
    EXPECT_EQ(d.boundary_edges, 3U + 2U + 7U);
    EXPECT_EQ(close_gaps(mesh, gap).t_junctions, 0U);
  }
}

TEST(CloseGaps, TellsTheNewFacetsWhatTheFileSaysOfTheSplitOne) {
  FacetMesh mesh = repaired(square_on_strip(3, 0.0));
  mesh.part = {std::vector<std::uint32_t>(mesh.size(), 1), {"strip", "square"}};
  for (std::size_t k = 2; k < mesh.size(); ++k) mesh.part.of[k] = 0;
  mesh.source_facet[0] = 77;
  close_gaps(mesh, 0.0);
  ASSERT_EQ(mesh.size(), 10U);
  for (const std::size_t k : {0U, 8U, 9U}) {
    EXPECT_EQ(mesh.part.of[k], 1U);
    EXPECT_EQ(mesh.source_facet[k], 77U);
    EXPECT_GT(mesh.normals[k].z(), 0.99);
  }
}

TEST(CloseGaps, ClosesABoxWhoseFacesAreCutDifferently) {
  // The side x = 1 of the box has a vertex in each of its edges and one in the middle; its neighbours have not.
  FacetMesh mesh = unit_box();
  const FacetMesh whole = mesh;
  mesh.facets.erase(mesh.facets.begin() + 10, mesh.facets.end());
  mesh = mesh_of(mesh.positions, mesh.facets);
  std::vector<Vec3> grid;
  Triangles facets;
  for (int j = 0; j < 3; ++j)
    for (int k = 0; k < 3; ++k) grid.emplace_back(1.0, 0.5 * j, 0.5 * k);
  for (std::uint32_t j = 0; j < 2; ++j)
    for (std::uint32_t k = 0; k < 2; ++k) {
      const std::uint32_t a = 3 * j + k;
      facets.push_back({a, a + 3, a + 4});
      facets.push_back({a, a + 4, a + 1});
    }
  mesh = repaired(joined(mesh, mesh_of(grid, facets)));
  EXPECT_FALSE(diagnose(mesh).closed);
  EXPECT_EQ(diagnose(mesh).t_junctions, 4U);
  EXPECT_EQ(close_gaps(mesh, 0.0).t_junctions, 4U);
  const Diagnosis d = diagnose(mesh);
  EXPECT_TRUE(d.closed);
  EXPECT_NEAR(d.volume, 1.0, 1e-15);
  EXPECT_NEAR(d.area, 6.0, 1e-14);
}

TEST(CloseGaps, SurvivesRandomSoups) {
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    std::vector<Vec3> positions;
    Triangles facets;
    std::uint64_t state = seed;
    const auto random = [&] { return static_cast<double>((state = state * 6364136223846793005U + 1U) >> 60U) / 4.0; };
    for (std::uint32_t k = 0; k < 60; ++k) {
      for (int c = 0; c < 3; ++c) positions.emplace_back(random(), random(), random());
      facets.push_back({3 * k, 3 * k + 1, 3 * k + 2});
    }
    for (const double tolerance : {0.0, 0.3}) {
      FacetMesh mesh = repaired(mesh_of(positions, facets));
      const double before = area(mesh);
      EXPECT_TRUE(close_gaps(mesh, tolerance).complete);
      if (tolerance == 0.0) {
        EXPECT_NEAR(area(mesh), before, 1e-10);
      }
      EXPECT_EQ(find_gaps(mesh, 0.0).t_junctions.size(), 0U) << seed << " " << tolerance;
    }
  }
}

}  // namespace
}  // namespace lrcs
