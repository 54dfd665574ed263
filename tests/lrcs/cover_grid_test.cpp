#include "lrcs/cover_grid.h"

#include <gtest/gtest.h>

#include <random>

#include "lrcs/visibility.h"
#include "tests/lrcs/test_targets.h"

namespace lrcs {
namespace {

struct Counts {
  std::size_t hidden = 0, said = 0;  // facets that nothing is seen of; those said to be so
};

// What is said to be hidden is hidden by clipping, which knows nothing of the grid.
Counts expect_said_is_hidden(FacetMesh mesh, const Vec3& toward) {
  measure_facets(mesh);
  const Surface surface(mesh);
  ViewOutline view(surface);
  view.look_along(toward);
  CoverGrid cover;
  cover.find(surface, view);
  const auto seen = Visibility(mesh).seen_fraction_by_clipping(toward, toward);
  Counts counts;
  for (std::uint32_t f = 0; f < surface.occluders.size(); ++f) {
    if (view.counts(f) == 0) continue;
    const Estimate& its = seen[surface.occluders.original[f]];
    const bool said = cover.hides(view, surface.occluders.facets[f]);
    counts.hidden += its.value <= its.bound ? 1 : 0;
    counts.said += said ? 1 : 0;
    EXPECT_TRUE(!said || its.value <= its.bound) << "facet " << f << " is seen by " << its.value;
  }
  return counts;
}

// Squares of `size` side by side across z, in a plane z = `height`, two facets each.
void add_tiles(FacetMesh& mesh, double low, double high, int count, double height) {
  const double size = (high - low) / count;
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const auto across = static_cast<std::uint32_t>(count) + 1;
  for (int row = 0; row <= count; ++row)
    for (int column = 0; column <= count; ++column) add_vertex(mesh, {low + column * size, low + row * size, height});
  for (std::uint32_t row = 0; row + 1 < across; ++row)
    for (std::uint32_t column = 0; column + 1 < across; ++column) {
      const std::uint32_t corner = first + row * across + column;
      add_facet(mesh, corner, corner + 1, corner + across + 1);
      add_facet(mesh, corner, corner + across + 1, corner + across);
    }
}

TEST(CoverGrid, OnePanelHidesAllThatLiesWellBehindIt) {
  FacetMesh mesh;
  add_tiles(mesh, -1.0, 1.0, 1, 1.0);
  add_tiles(mesh, -0.9, 0.9, 20, 0.0);
  const Counts counts = expect_said_is_hidden(mesh, Vec3::UnitZ());
  EXPECT_EQ(counts.hidden, 800);
  EXPECT_EQ(counts.said, 800);
}

TEST(CoverGrid, ASheetOfSmallFacetsHidesLikeOnePanel) {
  FacetMesh mesh;
  add_tiles(mesh, -1.0, 1.0, 40, 1.0);
  add_tiles(mesh, -0.9, 0.9, 20, 0.0);
  const Counts counts = expect_said_is_hidden(mesh, Vec3(0.01, -0.02, 1.0).normalized());
  EXPECT_EQ(counts.hidden, 800);
  EXPECT_EQ(counts.said, 800);
}

TEST(CoverGrid, ASheetWithAHoleDoesNotHideWhatIsBehindTheHole) {
  FacetMesh mesh;
  add_tiles(mesh, -1.0, 1.0, 40, 1.0);
  mesh.facets.erase(mesh.facets.begin() + 1640);  // one facet
  add_tiles(mesh, -0.9, 0.9, 20, 0.0);
  const Counts counts = expect_said_is_hidden(mesh, Vec3(0.01, -0.02, 1.0).normalized());
  EXPECT_LT(counts.hidden, 800);
  EXPECT_GE(counts.said, 700);
}

// Two sheets that pass through each other: neither hides where it dives below the other, both together do.
TEST(CoverGrid, SheetsThatPassThroughEachOtherHideWhatIsBehindBoth) {
  FacetMesh mesh;
  add_tiles(mesh, -1.0, 1.0, 20, 1.0);
  for (Vec3& p : mesh.positions) p.z() += 0.2 * p.x();
  const std::size_t first = mesh.positions.size();
  add_tiles(mesh, -1.0, 1.0, 20, 1.0);
  for (std::size_t k = first; k < mesh.positions.size(); ++k) mesh.positions[k].z() -= 0.2 * mesh.positions[k].x();
  add_tiles(mesh, -0.9, 0.9, 10, 0.0);
  const Counts counts = expect_said_is_hidden(mesh, Vec3::UnitZ());
  EXPECT_GE(counts.said, 200);
}

TEST(CoverGrid, WhatIsSaidToBeHiddenIsHidden) {
  std::size_t hidden = 0, said = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> real(-1.0, 1.0);
    FacetMesh mesh = random_soup(random, 40);
    for (int k = 0; k < 6; ++k) {
      const Vec3 low(real(random), real(random), real(random));
      add_box(mesh, low, low + Vec3(0.2 + std::abs(real(random)), 0.2 + std::abs(real(random)), 0.05));
      FacetMesh tiles;
      add_tiles(tiles, low.x(), low.x() + 0.5, 4 + k, 0.3 * real(random));
      append(mesh, tiles);
    }
    const Counts counts = expect_said_is_hidden(mesh, seed % 3 == 0 ? Vec3(Vec3::UnitZ()) : random_direction(random));
    hidden += counts.hidden;
    said += counts.said;
  }
  // The grid is coarse, but not for nothing.
  EXPECT_GT(said, hidden / 4);
}

}  // namespace
}  // namespace lrcs
