#include "view/tiles.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/view/black_area.h"

namespace lrcs {
namespace {

TEST(Tiles, InkTheirArea) {
  Canvas canvas(60, 60);
  canvas.tiles({{{{10.3, 10.1}, {50.7, 20.2}, {25.1, 50.9}}, black}});
  const double area = 0.5 * ((50.7 - 10.3) * (50.9 - 10.1) - (25.1 - 10.3) * (20.2 - 10.1));
  EXPECT_NEAR(black_area(canvas), area, 0.01 * area);
}

TEST(Tiles, LeaveNoSeamBetweenNeighbours) {
  Canvas canvas(60, 60);
  const Point shared{23.37, 31.91};
  const std::vector<Point> rim{{5.0, 5.0}, {55.0, 5.0}, {55.0, 55.0}, {5.0, 55.0}};
  std::vector<Tile> tiles;
  for (std::size_t i = 0; i < 4; ++i) tiles.push_back({{rim[i], rim[(i + 1) % 4], shared}, black});
  canvas.tiles(tiles);
  EXPECT_DOUBLE_EQ(black_area(canvas), 2500.0);
}

TEST(Tiles, LieOverWhatWasThereAndLaterOverEarlier) {
  Canvas canvas(20, 20);
  const std::vector<Point> square{{4.0, 4.0}, {16.0, 4.0}, {16.0, 16.0}, {4.0, 16.0}};
  canvas.fill({{0.0, 0.0}, {20.0, 20.0}}, black);
  canvas.tiles({{square, black}, {square, white}});
  EXPECT_DOUBLE_EQ(black_area(canvas), 400.0 - 144.0);
}

TEST(Tiles, KeepToTheClipBoxAndToFinitePoints) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Canvas canvas(20, 20);
  canvas.clip({{5.0, 5.0}, {10.0, 10.0}});
  canvas.tiles({{{{-1e9, -1e9}, {1e9, -1e9}, {1e9, 1e9}, {-1e9, 1e9}}, black}, {{{0.0, 0.0}, {nan, 1.0}}, white}});
  EXPECT_DOUBLE_EQ(black_area(canvas), 25.0);
  canvas.tiles({});
  canvas.tiles({{{{30.0, 30.0}, {40.0, 30.0}, {40.0, 40.0}}, black}});
  EXPECT_DOUBLE_EQ(black_area(canvas), 25.0);
}

}  // namespace
}  // namespace lrcs
