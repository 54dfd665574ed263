#include "lrcs/row_drawing.h"

#include <gtest/gtest.h>

#include "lrcs/embree_scene.h"
#include "lrcs/row_rays.h"
#include "test_targets.h"

namespace lrcs {
namespace {

// The facets at all places of a grid, row by row.
std::vector<std::uint32_t> drawn(const FacetMesh& mesh, const RowGrid& grid) {
  RowDrawing drawing(mesh);
  drawing.look_along(grid);
  std::vector<std::uint32_t> facets;
  while (drawing.draw_more())
    for (std::uint32_t row = drawing.first_row(); row < drawing.last_row(); ++row)
      for (const Drawn& d : drawing.row(row)) facets.push_back(d.facet == Drawn::nothing ? Seen::nothing : d.facet);
  return facets;
}

std::vector<std::uint32_t> met(const FacetMesh& mesh, const RowGrid& grid) {
  const EmbreeScene scene(mesh);
  RowRays rays(mesh, scene);
  rays.look_along(grid, grid.toward);
  std::vector<std::uint32_t> facets(std::size_t{grid.rows} * grid.columns);
  for (std::uint32_t row = 0; row < grid.rows; row += RowRays::tile)
    for (std::uint32_t column = 0; column < grid.columns; column += RowRays::tile) {
      std::array<Seen, RowRays::width> seen;
      rays.cast(row, column, seen);
      for (std::uint32_t k = 0; k < RowRays::width; ++k) {
        const std::uint32_t r = row + k / RowRays::tile, c = column + k % RowRays::tile;
        if (r < grid.rows && c < grid.columns) facets[std::size_t{r} * grid.columns + c] = seen[k].facet;
      }
    }
  return facets;
}

// Rays in floats pass an edge on the other side here and there.
void expect_same(const FacetMesh& mesh, std::uint64_t seed, double size) {
  std::mt19937_64 random(seed);
  const RowGrids grids(mesh);
  for (int k = 0; k < 6; ++k) {
    const RowGrid grid = grids.over(random_direction(random), size);
    const auto a = drawn(mesh, grid), b = met(mesh, grid);
    ASSERT_EQ(a.size(), b.size());
    std::size_t differ = 0;
    for (std::size_t i = 0; i < a.size(); ++i) differ += a[i] != b[i] ? 1 : 0;
    EXPECT_LE(differ, a.size() / 2000) << k;
  }
}

TEST(RowDrawing, ShowsWhatRaysMeet) {
  FacetMesh mesh = sphere(1.0, 40);
  append(mesh, sphere(0.7, 20), {1.2, 0.3, 0.2});
  measure_facets(mesh);
  expect_same(mesh, 1, 50.0);
  expect_same(mesh, 2, 600.0);
}

TEST(RowDrawing, ShowsWhatRaysMeetOfATriangleSoup) {
  std::mt19937_64 random(3);
  FacetMesh mesh = random_soup(random, 500);
  measure_facets(mesh);
  expect_same(mesh, 3, 150.0);
}

TEST(RowDrawing, ShowsWhatRaysMeetOfATargetFarFromTheOrigin) {
  FacetMesh mesh = sphere(1e-3, 30);
  for (Vec3& p : mesh.positions) p += Vec3(10.0, -20.0, 5.0);
  measure_facets(mesh);
  expect_same(mesh, 4, 100.0);
}

TEST(RowDrawing, LeavesNoGapBetweenFacetsThatShareAnEdge) {
  FacetMesh mesh;
  add_tiled_plate(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 37);
  measure_facets(mesh);
  const RowGrids grids(mesh);
  const RowGrid grid = grids.over(Vec3(0.1, 0.2, 1.0).normalized(), 400.0);
  const auto facets = drawn(mesh, grid);
  for (std::uint32_t row = 0; row < grid.rows; ++row) {
    const auto first = facets.begin() + row * grid.columns, last = first + grid.columns;
    const auto is_facet = [](std::uint32_t f) { return f != Seen::nothing; };
    const auto start = std::find_if(first, last, is_facet);
    const auto end = std::find_if_not(start, last, is_facet);
    EXPECT_TRUE(std::none_of(end, last, is_facet)) << row;
  }
}

TEST(RowDrawing, TellsWhereFacetsLieInOnePlaceUnlessTheyAreTheSame) {
  FacetMesh mesh;
  add_plate(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  add_plate(mesh, {0.25, 0.25, 0}, {0.37, 0.01, 0}, {0, 0.41, 0});
  measure_facets(mesh);
  const auto tied = [&](const FacetMesh& of) {
    RowDrawing drawing(of);
    drawing.look_along(RowGrids(of).over(Vec3(0.3, 0.2, 1.0).normalized(), 200.0));
    double count = 0.0;
    while (drawing.draw_more())
      for (std::uint32_t row = drawing.first_row(); row < drawing.last_row(); ++row)
        for (const Drawn& d : drawing.row(row)) count += d.tied;
    return count;
  };
  const double small = 0.37 * 0.41 / 1.0;
  EXPECT_GT(tied(mesh), 0.3 * small * 200.0 * 200.0 / 2.0);
  FacetMesh twice;
  add_plate(twice, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  add_facet(twice, 2, 1, 0);
  measure_facets(twice);
  EXPECT_EQ(tied(twice), 0.0);
}

}  // namespace
}  // namespace lrcs
