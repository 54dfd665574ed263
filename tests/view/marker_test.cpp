#include "view/marker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace lrcs {
namespace {

struct Ink {
  double area = 0.0, x = 0.0, y = 0.0;
};

Ink ink_of(MarkerShape shape, const Point& centre, double radius) {
  Canvas canvas(80, 80);
  draw_markers(canvas, {centre}, {shape, black, radius});
  Ink ink;
  for (int row = 0; row < 80; ++row)
    for (int column = 0; column < 80; ++column) {
      const double share = 1.0 - canvas.picture().rgb[static_cast<std::size_t>(3 * (80 * row + column))] / 255.0;
      ink.area += share;
      ink.x += share * (column + 0.5);
      ink.y += share * (row + 0.5);
    }
  ink.x /= ink.area;
  ink.y /= ink.area;
  return ink;
}

TEST(Marker, IsCentredOnItsPointInEveryShape) {
  for (std::size_t shape = 0; shape < 8; ++shape) {
    const Ink ink = ink_of(marker_shape(shape), {40.3, 39.6}, 12.0);
    EXPECT_NEAR(ink.x, 40.3, 0.1) << shape;
    EXPECT_NEAR(ink.y, 39.6, 0.1) << shape;
  }
}

TEST(Marker, InksAsMuchInEveryFilledShape) {
  using enum MarkerShape;
  for (const MarkerShape shape : {disc, square, triangle, diamond, inverted_triangle})
    EXPECT_NEAR(ink_of(shape, {40.0, 40.0}, 12.0).area, std::numbers::pi * 144.0, 11.0) << static_cast<int>(shape);
}

TEST(Marker, HasEightShapesThatDiffer) {
  std::set<MarkerShape> shapes;
  for (std::size_t curve = 0; curve < 8; ++curve) shapes.insert(marker_shape(curve));
  EXPECT_EQ(shapes.size(), 8U);
  EXPECT_EQ(marker_shape(8), marker_shape(0));
}

TEST(Marker, StandsApartFromWhatLiesBehindByAWhiteRim) {
  Canvas canvas(80, 80);
  canvas.fill({{0.0, 0.0}, {80.0, 80.0}}, black);
  draw_markers(canvas, {{40.5, 40.5}}, {MarkerShape::disc, black, 12.0});
  EXPECT_EQ(canvas.picture().rgb[static_cast<std::size_t>(3 * (80 * 40 + 40 + 13))], 255);
}

TEST(Marker, IsNotDrawnWhereItsPointIsNotFinite) {
  Canvas canvas(20, 20);
  draw_markers(canvas, {{std::numeric_limits<double>::quiet_NaN(), 3.0}}, {MarkerShape::disc, black, 5.0});
  EXPECT_EQ(canvas.picture().rgb, Canvas(20, 20).picture().rgb);
}

}  // namespace
}  // namespace lrcs
