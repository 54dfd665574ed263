#include "lrcs/cover_grid.h"

#include <gtest/gtest.h>

#include <random>

#include "lrcs/visibility.h"
#include "tests/lrcs/test_targets.h"

namespace lrcs {
namespace {

struct HiddenCounts {
  std::size_t hidden = 0, said = 0;  // facets that nothing is seen of; those said to be so
};

// What is said to be hidden is hidden by clipping, which knows nothing of the grid.
HiddenCounts expect_said_is_hidden(FacetMesh mesh, const Vec3& toward) {
  measure_facets(mesh);
  const Surface surface(mesh);
  ViewOutline view(surface);
  view.look_along(toward);
  CoverGrid cover;
  cover.find(surface, view);
  const auto seen = Visibility(mesh).seen_fraction_by_clipping(toward, toward);
  HiddenCounts counts;
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

// A square of count x count tiles about the z axis, at a height.
void add_sheet(FacetMesh& mesh, double half, std::uint32_t count, double height) {
  add_tiled_plate(mesh, {-half, -half, height}, {2 * half, 0, 0}, {0, 2 * half, 0}, count);
}

void expect_all_said_behind_sheet(std::uint32_t count, const Vec3& toward) {
  FacetMesh mesh;
  add_sheet(mesh, 1.0, count, 1.0);
  add_sheet(mesh, 0.9, 20, 0.0);
  const HiddenCounts counts = expect_said_is_hidden(mesh, toward);
  EXPECT_EQ(counts.hidden, 800);
  EXPECT_EQ(counts.said, 800);
}

TEST(CoverGrid, OnePanelHidesAllThatLiesWellBehindIt) {
  expect_all_said_behind_sheet(1, Vec3::UnitZ());
}

TEST(CoverGrid, ASheetOfSmallFacetsHidesLikeOnePanel) {
  expect_all_said_behind_sheet(40, Vec3(0.01, -0.02, 1.0).normalized());
}

TEST(CoverGrid, ASheetWithAHoleDoesNotHideWhatIsBehindTheHole) {
  FacetMesh mesh;
  add_sheet(mesh, 1.0, 40, 1.0);
  mesh.facets.erase(mesh.facets.begin() + 1640);  // one facet
  add_sheet(mesh, 0.9, 20, 0.0);
  const HiddenCounts counts = expect_said_is_hidden(mesh, Vec3(0.01, -0.02, 1.0).normalized());
  EXPECT_LT(counts.hidden, 800);
  EXPECT_GE(counts.said, 700);
}

// Two sheets that pass through each other: neither hides where it dives below the other, both together do.
TEST(CoverGrid, SheetsThatPassThroughEachOtherHideWhatIsBehindBoth) {
  FacetMesh mesh;
  add_sheet(mesh, 1.0, 20, 1.0);
  for (Vec3& p : mesh.positions) p.z() += 0.2 * p.x();
  const std::size_t first = mesh.positions.size();
  add_sheet(mesh, 1.0, 20, 1.0);
  for (std::size_t k = first; k < mesh.positions.size(); ++k) mesh.positions[k].z() -= 0.2 * mesh.positions[k].x();
  add_sheet(mesh, 0.9, 10, 0.0);
  const HiddenCounts counts = expect_said_is_hidden(mesh, Vec3::UnitZ());
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
      const auto count = static_cast<std::uint32_t>(4 + k);
      add_tiled_plate(mesh, {low.x(), low.x(), 0.3 * real(random)}, {0.5, 0, 0}, {0, 0.5, 0}, count);
    }
    const HiddenCounts counts =
        expect_said_is_hidden(mesh, seed % 3 == 0 ? Vec3(Vec3::UnitZ()) : random_direction(random));
    hidden += counts.hidden;
    said += counts.said;
  }
  // The grid is coarse, but not for nothing.
  EXPECT_GT(said, hidden / 4);
}

}  // namespace
}  // namespace lrcs
