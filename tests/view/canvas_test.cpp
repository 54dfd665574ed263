#include "view/canvas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "tests/view/black_area.h"
#include "view/dashes.h"
#include "view/vtk_errors.h"

namespace lrcs {
namespace {

TEST(Canvas, FillsExactlyTheBoxBetweenPixels) {
  Canvas canvas(40, 30);
  canvas.fill({{3.25, 4.5}, {10.75, 9.25}}, black);
  EXPECT_NEAR(black_area(canvas), 7.5 * 4.75, 0.1);
}

TEST(Canvas, InksALineOverItsLengthAndWidth) {
  for (const Point to : {Point{180.0, 20.0}, Point{180.0, 90.0}, Point{110.0, 110.0}}) {
    Canvas canvas(200, 130);
    canvas.line({{20.0, 20.0}, to}, {black, 5.0});
    const double length = std::hypot(to.x - 20.0, to.y - 20.0);
    const double ends = std::numbers::pi * 2.5 * 2.5;
    EXPECT_NEAR(black_area(canvas), 5.0 * length + ends, 0.02 * 5.0 * length);
  }
}

TEST(Canvas, InksALineNoTwiceWhereItsPartsMeet) {
  Canvas whole(200, 60);
  Canvas parts(200, 60);
  whole.line({{20.0, 20.0}, {180.0, 40.0}}, {black, 3.0});
  std::vector<Point> points;
  for (int i = 0; i <= 160; ++i) points.push_back({20.0 + i, 20.0 + i / 8.0});
  parts.line(points, {black, 3.0});
  EXPECT_NEAR(black_area(parts), black_area(whole), 0.01 * black_area(whole));
}

TEST(Canvas, InksADiscOverItsArea) {
  Canvas canvas(60, 60);
  canvas.disc({30.3, 29.8}, 20.0, black);
  EXPECT_NEAR(black_area(canvas), std::numbers::pi * 400.0, 5.0);
}

TEST(Canvas, DrawsNothingOutsideTheClipBox) {
  Canvas canvas(60, 60);
  canvas.clip({{10.0, 10.0}, {20.0, 20.0}});
  canvas.fill({{-100.0, -100.0}, {200.0, 200.0}}, black);
  canvas.line({{-1e6, 15.0}, {1e6, 15.0}}, {black, 3.0});
  EXPECT_NEAR(black_area(canvas), 100.0, 0.01);
}

TEST(Canvas, DrawsWhatIsSeenOfLinesThatEndFarAwayOrNowhere) {
  constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
  const VtkErrors errors;
  Canvas canvas(60, 60);
  canvas.clip({{10.0, 0.0}, {20.0, 60.0}});
  canvas.line({{-1e300, 15.0}, {1e300, 15.0}}, {black, 3.0});
  canvas.line({{30.0, -1e9}, {30.0, 1e9}, {-1e9, 1e9}}, {black, 3.0});
  canvas.line({{nowhere, 40.0}, {15.0, nowhere}, {0.0, 40.0}, {60.0, 40.0}}, {black, 3.0});
  EXPECT_NEAR(black_area(canvas), 60.0, 0.2);
  EXPECT_EQ(errors.first(), "");
}

TEST(Canvas, DrawsStrokesAsTheirLines) {
  const std::vector<std::vector<Point>> strokes{{{10.0, 10.0}, {50.0, 12.0}, {40.0, 50.0}}, {{20.0, 40.0}}, {}};
  Canvas at_once(60, 60);
  Canvas in_turn(60, 60);
  at_once.strokes(strokes, {black, 4.0});
  for (const auto& stroke : strokes) in_turn.line(stroke, {black, 4.0});
  EXPECT_EQ(at_once.picture().rgb, in_turn.picture().rgb);
}

TEST(Canvas, MagnifiesAllThatIsDrawn) {
  constexpr int factor = 3;
  const auto drawn = [](Canvas canvas) {
    EXPECT_EQ(canvas.width(), 200.0);
    EXPECT_EQ(canvas.height(), 100.0);
    const Font font{20, false};
    const std::vector<Point> corner{{110.0, 10.0}, {130.0, 10.0}, {130.0, 30.0}};
    canvas.clip({{0.0, 0.0}, {190.0, 100.0}});
    canvas.fill({{10.0, 10.0}, {30.0, 20.0}}, black);
    canvas.line({{10.0, 40.0}, {200.0, 40.0}}, {black, 4.0, {12.0, 8.0}});
    canvas.strokes({{{10.0, 50.0}, {60.0, 50.0}}}, {black, 3.0});
    canvas.circle({50.0, 80.0}, 10.0, {black, 3.0});
    canvas.disc({90.0, 80.0}, 10.0, black);
    canvas.area(corner, black, 1.0);
    canvas.tiles({{{{140.0, 10.0}, {160.0, 10.0}, {160.0, 30.0}}, black}});
    canvas.text({120.0, 70.0}, "HEL", {.font = font, .colour = black});
    canvas.no_clip();
    return black_area(canvas);
  };
  const double plain = drawn({200, 100}), magnified = drawn({factor * 200, factor * 100, Recording::none, factor});
  EXPECT_NEAR(magnified / (factor * factor * plain), 1.0, 0.03);
  Canvas canvas(200, 100, Recording::none, 2.0);
  EXPECT_THROW(canvas.paste(Picture{1, 1, {0, 0, 0}}, 0, 0), std::logic_error);
  EXPECT_THROW(Canvas(200, 100, Recording::none, 0.0), std::invalid_argument);
}

// Letters have whole sizes: 36 becomes 9, 30 becomes 7.5.
TEST(Canvas, DrawsTextNoWiderThanItWasMeasuredAtAnyMagnification) {
  for (const double magnification : {0.25, 0.33, 0.7, 1.0, 1.9})
    for (const int size : {30, 36, 46}) {
      const Font font{size, false};
      const std::string text = "Monostatic LRCS of tess.obj";
      Canvas canvas(1000, 100, Recording::none, magnification);
      canvas.text({0.0, 20.0 / magnification}, text, {.font = font, .colour = black});
      int right = 0;
      const Picture& picture = canvas.picture();
      for (int k = 0; k < picture.width * picture.height; ++k)
        if (picture.rgb[3 * static_cast<std::size_t>(k)] < 128) right = std::max(right, k % picture.width);
      EXPECT_GT(right, 50);
      EXPECT_LE(right, std::ceil(magnification * text_size(text, font).width) + 2.0) << magnification << " " << size;
    }
}

TEST(Canvas, MagnifiesWhatItRecords) {
  Canvas canvas(600, 300, Recording::shapes, 3.0);
  canvas.text({20.0, 10.0}, "H", {.font = {20, false}});
  canvas.line({{1.0, 2.0}, {3.0, 4.0}}, {black, 2.0});
  const std::string svg = canvas.svg();
  EXPECT_NE(svg.find("font-size=\"60\""), std::string::npos) << svg;
  EXPECT_NE(svg.find("stroke-width=\"6\""), std::string::npos) << svg;
}

TEST(Canvas, TurnsTextByAQuarter) {
  Canvas flat(300, 300);
  Canvas upward(300, 300);
  flat.text({20.0, 40.0}, "LRCS [dBsm]", {.font = {30, false}, .colour = black});
  upward.text({40.0, 20.0}, "LRCS [dBsm]", {.font = {30, false}, .colour = black, .upward = true});
  EXPECT_GT(black_area(flat), 500.0);
  EXPECT_NEAR(black_area(upward), black_area(flat), 1e-6 * black_area(flat));
}

TEST(Canvas, RefusesASheetWithoutPixels) {
  EXPECT_THROW(Canvas(0, 10), std::invalid_argument);
  EXPECT_THROW(Canvas(10, -1), std::invalid_argument);
}

TEST(TextBitmap, HasTheSignsThatPlotsNeed) {
  for (const std::string sign : {"−", "°", "²", "≤", "[", "(", "µ", "é"}) {
    const TextBitmap bitmap = text_bitmap(sign, {36, false});
    int inked = 0;
    for (const std::uint8_t coverage : bitmap.coverage) inked += coverage > 100 ? 1 : 0;
    EXPECT_GT(inked, 10) << sign;
  }
}

TEST(Fitting, MakesTextNoWiderThanItsRoom) {
  const std::string text = "a title that is too long for its picture";
  const Font fitted = fitting(text, {40, true}, 600.0);
  EXPECT_LE(text_size(text, fitted).width, 600.0);
  EXPECT_LT(fitted.size, 40);
  EXPECT_EQ(fitting("short", {40, true}, 600.0).size, 40);
}

double length_of(const std::vector<std::vector<Point>>& strokes) {
  double length = 0.0;
  for (const auto& stroke : strokes) {
    for (std::size_t i = 1; i < stroke.size(); ++i) {
      length += std::hypot(stroke[i].x - stroke[i - 1].x, stroke[i].y - stroke[i - 1].y);
    }
  }
  return length;
}

TEST(Dashes, InkTheirShareOfTheLineAroundCorners) {
  const std::vector<Point> line{{0.0, 0.0}, {70.0, 0.0}, {70.0, 50.0}};
  const auto strokes = dashes(line, {10.0, 5.0});
  EXPECT_EQ(strokes.size(), 8U);
  EXPECT_NEAR(length_of(strokes), 80.0, 1e-9);
  EXPECT_NEAR(length_of(dashes(line, {})), 120.0, 1e-9);
}

TEST(Dashes, RefuseAPatternThatWouldNeverEnd) {
  EXPECT_THROW((void)dashes({{0.0, 0.0}, {1.0, 0.0}}, {0.0, 0.0}), std::invalid_argument);
  EXPECT_THROW((void)dashes({{0.0, 0.0}, {1.0, 0.0}}, {3.0}), std::invalid_argument);
}

}  // namespace
}  // namespace lrcs
