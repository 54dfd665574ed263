#include "view/sweep_plot.h"

#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "png_pixels.h"

namespace lrcs {
namespace {

const PlotText text{"Title", "azimuth [deg]"};

using Draw = void (*)(const std::filesystem::path&, const std::vector<Curve>&, const PlotText&);

// 0 dBsm at the ends, `peak` dBsm at peak_deg, straight in dB between; every degree from 0 to 180.
Curve one_peak(double peak_deg, double peak_dbsm) {
  Curve curve{"one peak", {}, {}};
  for (int angle = 0; angle <= 180; ++angle) {
    const double share = angle < peak_deg ? angle / peak_deg : (180.0 - angle) / (180.0 - peak_deg);
    curve.angle_deg.push_back(angle);
    curve.sigma_m2.push_back(std::pow(10.0, 0.1 * peak_dbsm * share));
  }
  return curve;
}

Curve constant(double from_deg, double to_deg, double step_deg, double sigma_m2) {
  Curve curve{"constant", {}, {}};
  for (double angle = from_deg; angle <= to_deg; angle += step_deg) {
    curve.angle_deg.push_back(angle);
    curve.sigma_m2.push_back(sigma_m2);
  }
  return curve;
}

// The columns in which the colour reaches the top of the box it fills.
double column_of_top(const PngPixels& pixels, const Colour& colour) {
  const Found found = find_colour(pixels, colour);
  double sum = 0.0;
  int count = 0;
  for (int column = 0; column < pixels.size[0]; ++column) {
    if (!pixels.is(colour, column, found.top)) continue;
    sum += column + 0.5;
    ++count;
  }
  return sum / count;
}

TEST(SweepPlot, HasItsSizeAndShowsTheCurveInItsColour) {
  const auto png = scratch_file("sweep.png");
  draw_sweep_plot(png, {one_peak(90.0, 30.0)}, text);
  const PngPixels pixels(png);
  EXPECT_EQ(pixels.size[0], 1600);
  EXPECT_EQ(pixels.size[1], 1000);
  EXPECT_GT(find_colour(pixels, curve_colour(0)).count, 3000);
  EXPECT_GT(find_colour(pixels, ink).count, 3000);
}

TEST(SweepPlot, PutsThePeakAtItsAngle) {
  for (const double peak_deg : {30.0, 90.0, 135.0}) {
    const auto png = scratch_file("sweep.png");
    draw_sweep_plot(png, {one_peak(peak_deg, 30.0)}, text);
    const PngPixels pixels(png);
    const Found line = find_colour(pixels, curve_colour(0));
    // Full ink begins half a line's width outside both end points.
    const double expected = line.left + 0.5 + (line.right - line.left) * peak_deg / 180.0;
    EXPECT_NEAR(column_of_top(pixels, curve_colour(0)), expected, 3.0) << peak_deg;
  }
}

TEST(SweepPlot, DrawsDecibelsToScale) {
  const auto png = scratch_file("sweep.png");
  draw_sweep_plot(png, {constant(0, 180, 1, 1000.0), constant(0, 180, 1, 100.0), constant(0, 180, 1, 1.0)}, text);
  const PngPixels pixels(png);
  // Only the box of the curve's line: the legend has a short one of the same colour above.
  std::array<double, 3> row{};
  for (std::size_t curve = 0; curve < 3; ++curve) {
    const int middle = 800;
    int first = 0;
    while (!pixels.is(curve_colour(curve), middle, first)) ++first;
    row[curve] = first;
  }
  EXPECT_NEAR((row[0] - row[1]) / (row[1] - row[2]), 0.5, 0.01);
}

TEST(SweepPlot, LeavesAGapWhereSigmaIsZero) {
  Curve curve = constant(0, 180, 1, 1.0);
  for (std::size_t i = 60; i <= 120; ++i) curve.sigma_m2[i] = 0.0;
  const auto png = scratch_file("sweep.png");
  draw_sweep_plot(png, {curve}, text);
  const PngPixels pixels(png);
  const Found line = find_colour(pixels, curve_colour(0));
  const int height = line.top - 1;
  const auto column = [&](double angle) {
    return static_cast<int>(line.left + (line.right - line.left) * angle / 180.0);
  };
  EXPECT_TRUE(pixels.is(curve_colour(0), column(30), height));
  EXPECT_FALSE(pixels.is(curve_colour(0), column(61), height));
  EXPECT_FALSE(pixels.is(curve_colour(0), column(90), height));
  EXPECT_TRUE(pixels.is(curve_colour(0), column(150), height));
  // Its floor ticks are there instead.
  EXPECT_LT(line.bottom, height - 100);
}

TEST(SweepPlot, ShowsOneDirectionAsADot) {
  const auto png = scratch_file("sweep.png");
  draw_sweep_plot(png, {{"one", {17.0}, {3.0}}}, text);
  const Found dot = find_colour(PngPixels(png), curve_colour(0));
  EXPECT_NEAR(dot.right - dot.left, dot.top - dot.bottom, 1);
  EXPECT_GT(dot.count, 100);
}

TEST(SweepPlot, DrawsASweepThatIsZeroThroughout) {
  for (const Draw draw : {Draw(draw_sweep_plot), Draw(draw_polar_plot)}) {
    const auto png = scratch_file("plot.png");
    draw(png, {{"dark", {0.0, 10.0, 20.0}, {0.0, 0.0, 0.0}}}, text);
    EXPECT_GT(find_colour(PngPixels(png), ink).count, 3000);
  }
}

TEST(SweepPlot, DrawsTenThousandDirections) {
  const auto png = scratch_file("sweep.png");
  draw_sweep_plot(png, {constant(0.0, 359.97, 0.036, 2.0)}, text);
  EXPECT_GT(find_colour(PngPixels(png), curve_colour(0)).count, 3000);
}

TEST(SweepPlot, GivesTheSameBytesTwice) {
  for (const Draw draw : {Draw(draw_sweep_plot), Draw(draw_polar_plot)}) {
    const auto first = scratch_file("first.png");
    const auto second = scratch_file("second.png");
    draw(first, {one_peak(70.0, 20.0), constant(0, 180, 7, 2.0)}, text);
    draw(second, {one_peak(70.0, 20.0), constant(0, 180, 7, 2.0)}, text);
    EXPECT_EQ(bytes_of(first), bytes_of(second));
    EXPECT_FALSE(bytes_of(first).empty());
  }
}

TEST(SweepPlot, NeedsNeitherDisplayNorXServer) {
  const auto png = scratch_file("sweep.png");
  exit_in_fresh_process();
  EXPECT_EXIT(
      {
        unsetenv("DISPLAY");
        setenv("PATH", "/nonexistent", 1);
        draw_sweep_plot(png, {one_peak(90.0, 30.0)}, text);
        draw_polar_plot(png, {one_peak(90.0, 30.0)}, text);
        std::exit(0);
      },
      testing::ExitedWithCode(0), "");
}

TEST(SweepPlot, RefusesCurvesThatCannotBe) {
  const auto png = scratch_file("sweep.png");
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Curve> wrong{{"lengths", {0.0, 1.0}, {1.0}},
                                 {"negative", {0.0}, {-1.0}},
                                 {"value nan", {0.0}, {nan}},
                                 {"angle nan", {nan}, {1.0}}};
  for (const Curve& curve : wrong) {
    EXPECT_THROW(draw_sweep_plot(png, {curve}, text), std::invalid_argument) << curve.label;
    EXPECT_THROW(draw_polar_plot(png, {curve}, text), std::invalid_argument) << curve.label;
  }
  EXPECT_THROW(draw_sweep_plot(png, {}, text), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(png));
}

TEST(SweepPlot, LeavesNothingBehindWhereItCannotWrite) {
  const auto png = scratch_file("sweep.png").parent_path() / "no such folder" / "sweep.png";
  EXPECT_THROW(draw_sweep_plot(png, {one_peak(90.0, 30.0)}, text), std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(png.parent_path()));
}

Found dot_at(double angle_deg, CutAngle angle) {
  const auto png = scratch_file("polar.png");
  draw_polar_plot(png, {{"one", {angle_deg}, {1.0}}}, {"", "angle [deg]", angle});
  const PngPixels pixels(png);
  EXPECT_EQ(pixels.size[0], 1200);
  EXPECT_EQ(pixels.size[1], 1200);
  return find_colour(pixels, curve_colour(0));
}

// Where the dot of a single direction lies, seen from that of the opposite one: +1 right or up, -1 left or down.
std::array<int, 2> side_of_dot(double angle_deg, CutAngle angle) {
  const Found dot = dot_at(angle_deg, angle);
  const Found opposite = dot_at(angle_deg + 180.0, angle);
  const auto sign = [](double d) { return std::abs(d) < 1.0 ? 0 : (d > 0.0 ? 1 : -1); };
  return {sign(dot.column - opposite.column), sign(dot.row - opposite.row)};
}

TEST(PolarPlot, LaysAzimuthAsSeenFromAboveWithTheNoseUp) {
  using Side = std::array<int, 2>;
  EXPECT_EQ(side_of_dot(0.0, CutAngle::azimuth), (Side{0, 1}));
  EXPECT_EQ(side_of_dot(90.0, CutAngle::azimuth), (Side{-1, 0}));
  EXPECT_EQ(side_of_dot(180.0, CutAngle::azimuth), (Side{0, -1}));
  EXPECT_EQ(side_of_dot(-90.0, CutAngle::azimuth), (Side{1, 0}));
}

TEST(PolarPlot, LaysElevationWithTheNoseToTheRightAndUpUp) {
  using Side = std::array<int, 2>;
  EXPECT_EQ(side_of_dot(0.0, CutAngle::elevation), (Side{1, 0}));
  EXPECT_EQ(side_of_dot(90.0, CutAngle::elevation), (Side{0, 1}));
  EXPECT_EQ(side_of_dot(-90.0, CutAngle::elevation), (Side{0, -1}));
}

TEST(PolarPlot, DrawsAConstantCutAsAClosedCircle) {
  const auto png = scratch_file("polar.png");
  draw_polar_plot(png, {constant(0, 350, 10, 1.0)}, text);
  const PngPixels pixels(png);
  const Found circle = find_colour(pixels, curve_colour(0));
  const double radius = 0.5 * (circle.right - circle.left) - 8.0;  // 36 dots reach 8 pixels out
  const double x = 0.5 * (circle.left + circle.right);
  const double y = 0.5 * (circle.bottom + circle.top);
  int missing = 0;
  for (int angle = 0; angle < 360; ++angle) {
    // A label may lie over the circle.
    if (angle > 30 && angle < 60) continue;
    const double radians = angle * 3.14159265358979 / 180.0;
    const int column = static_cast<int>(std::lround(x + radius * std::cos(radians)));
    const int row = static_cast<int>(std::lround(y + radius * std::sin(radians)));
    if (!pixels.is(curve_colour(0), column, row, 60)) ++missing;
  }
  EXPECT_EQ(missing, 0);
}

}  // namespace
}  // namespace lrcs
