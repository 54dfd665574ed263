#include "view/fit_plot.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <stdexcept>

#include "plot_frame.h"

namespace lrcs {
namespace {

// Measured at -60, 0 and 60 deg; the fit a straight line from -80 to 80 deg.
FitCurve three_points(double theta_i_deg, double fitted_at_0) {
  return {
      theta_i_deg,     {-60.0, 0.0, 60.0}, {0.02, 0.1, 0.05}, {-80.0, 80.0}, {fitted_at_0 - 0.04, fitted_at_0 + 0.04},
      {4.0, -3.0, 1.0}};
}

// The frames of a picture whose angles span -80..80 deg; the zero line is a frame's line too.
struct Panels {
  explicit Panels(const PngPixels& pixels, double y_low, double y_high, double largest_residual) {
    const auto columns = ink_lines(pixels, false, 300);
    const auto rows = ink_lines(pixels, true, 900);
    if (columns.size() != 2 || rows.size() != 5) throw std::runtime_error("no two frames with a zero line");
    constexpr double room = 0.02 * 160.0;
    const double end = 1.08 * largest_residual;
    residuals = {columns[0], columns[1], rows[0], rows[2], -80.0 - room, 80.0 + room, -end, end};
    zero = rows[1];
    values = residuals;
    values.bottom = rows[3];
    values.top = rows[4];
    values.y_low = y_low;
    values.y_high = y_high;
  }
  PlotFrame values{}, residuals{};
  double zero = 0.0;
};

PngPixels drawn(const FitPicture& picture) {
  const auto png = scratch_file("fit.png");
  draw_fit_plot(png, picture);
  return PngPixels(png);
}

TEST(FitPlot, PutsASymbolWhereItsValueSays) {
  const FitCurve curve = three_points(30.0, 0.1);
  const PngPixels pixels = drawn({"Fit", "a note", {curve}, ValueScale::linear});
  EXPECT_EQ(pixels.size[0], 1600);
  EXPECT_EQ(pixels.size[1], 1300);
  const Panels panels(pixels, 0.0, 0.15, 4.0);
  for (const std::size_t i : {0U, 2U}) {  // the line passes through the symbol at 0 deg
    const double column = panels.values.column(curve.measured_theta_r_deg[i]);
    const double row = panels.values.row(curve.measured_f_r_per_sr[i]);
    const Found symbol = find_near(pixels, curve_colour(0), column, row, 14.0);
    EXPECT_GT(symbol.count, 150) << i;
    EXPECT_NEAR(symbol.column, column, 0.7) << i;
    EXPECT_NEAR(symbol.row, row, 0.7) << i;
  }
}

TEST(FitPlot, DrawsTheFitAsALineThroughItsValues) {
  const PngPixels pixels = drawn({"Fit", "", {three_points(30.0, 0.08)}, ValueScale::linear});
  const PlotFrame frame = Panels(pixels, 0.0, 0.12, 4.0).values;
  for (const double angle : {-75.0, -40.0, -20.0, 20.0, 40.0, 75.0})
    EXPECT_TRUE(frame.is_at(pixels, curve_colour(0), angle, 0.08 + 0.04 * angle / 80.0)) << angle;
}

TEST(FitPlot, DrawsResidualsAboutAZeroLine) {
  const FitCurve curve = three_points(30.0, 0.08);
  const PngPixels pixels = drawn({"Fit", "", {curve}, ValueScale::linear});
  const Panels panels(pixels, 0.0, 0.12, 4.0);
  EXPECT_NEAR(panels.zero, panels.residuals.row(0.0), 0.6);
  for (std::size_t i = 0; i < 3; ++i) {
    const double column = panels.residuals.column(curve.measured_theta_r_deg[i]);
    const double row = panels.residuals.row(curve.residual[i]);
    const Found symbol = find_near(pixels, curve_colour(0), column, row, 14.0);
    EXPECT_NEAR(symbol.column, column, 0.7) << i;
    EXPECT_NEAR(symbol.row, row, 0.7) << i;
  }
}

TEST(FitPlot, NamesEachIncidenceInItsColourAboveTheFrame) {
  FitPicture picture{"Fit", "", {}, ValueScale::linear};
  for (std::size_t k = 0; k < 5; ++k) picture.curves.push_back(three_points(10.0 * static_cast<double>(k), 0.08));
  const PngPixels pixels = drawn(picture);
  const int top = static_cast<int>(Panels(pixels, 0.0, 0.12, 4.0).values.top);
  for (std::size_t k = 0; k < 5; ++k) EXPECT_GT(find_colour(pixels, curve_colour(k)).top, top + 10) << k;
}

// Fitted lines along a column between the symbols.
int lines_at(const PngPixels& pixels, const PlotFrame& frame, double angle) {
  const int column = static_cast<int>(frame.column(angle));
  int lines = 0;
  bool in_line = false;
  for (int row = static_cast<int>(frame.bottom) + 4; row < static_cast<int>(frame.top) - 3; ++row) {
    bool coloured = false;
    for (std::size_t k = 0; k < 7; ++k) coloured = coloured || pixels.is(curve_colour(k), column, row);
    if (coloured && !in_line) ++lines;
    in_line = coloured;
  }
  return lines;
}

FitPicture constants(std::size_t count) {
  FitPicture picture{"Fit", "", {}, ValueScale::linear};
  for (std::size_t k = 0; k < count; ++k) {
    const double f_r = 0.0097 * static_cast<double>(k + 1);
    picture.curves.push_back({5.0 * static_cast<double>(k), {60.0}, {f_r}, {-80.0, 80.0}, {f_r, f_r}, {4.0}});
  }
  return picture;
}

TEST(FitPlot, DrawsEveryIncidence) {
  for (const std::size_t count : {3U, 8U}) {
    const PngPixels pixels = drawn(constants(count));
    const PlotFrame frame = Panels(pixels, 0.0, 1.0, 4.0).values;
    int most = 0;  // the eighth line is dashed
    for (double angle = -70.0; angle < -60.0; angle += 1.0) most = std::max(most, lines_at(pixels, frame, angle));
    EXPECT_EQ(most, static_cast<int>(count));
  }
}

TEST(FitPlot, TakesALogarithmicAxisOverFiveDecades) {
  FitCurve curve = three_points(0.0, 1.0);
  curve.measured_f_r_per_sr = {1e-4, 1e-2, 10.0};
  const PngPixels pixels = drawn({"Fit", "", {curve}});
  const PlotFrame frame = Panels(pixels, -4.0, 1.0, 4.0).values;
  for (std::size_t i = 0; i < 3; ++i) {
    const double row = frame.row(std::log10(curve.measured_f_r_per_sr[i]));
    const Found symbol = find_near(pixels, curve_colour(0), frame.column(curve.measured_theta_r_deg[i]), row, 14.0);
    EXPECT_GT(symbol.count, 150) << i;
    EXPECT_NEAR(symbol.row, row, 0.7) << i;
  }
}

TEST(FitPlot, LeavesOutPointsBelowALogarithmicAxis) {
  FitCurve curve = three_points(0.0, 1.0);
  curve.measured_f_r_per_sr = {0.0, -1.0, 10.0};
  const PngPixels pixels = drawn({"Fit", "", {curve}, ValueScale::logarithmic});
  const Panels panels(pixels, -1.0, 1.0, 4.0);
  const auto between = [&](double row) { return row > panels.residuals.top + 3.0 && row < panels.values.bottom - 3.0; };
  for (int row = 0; row < pixels.size[1]; ++row)
    for (int column = 0; between(row) && column < pixels.size[0]; ++column)
      ASSERT_FALSE(pixels.is(curve_colour(0), column, row));
}

TEST(FitPlot, ShowsNegativeMeasuredValuesOnALinearAxis) {
  FitCurve curve = three_points(0.0, 0.06);
  curve.measured_f_r_per_sr = {-0.01, 0.1, 0.05};
  const PngPixels pixels = drawn({"Fit", "", {curve}, ValueScale::linear});
  const PlotFrame frame = Panels(pixels, -0.02, 0.1, 4.0).values;
  EXPECT_TRUE(frame.is_at(pixels, curve_colour(0), -60.0, -0.01));
}

TEST(FitPlot, ShowsTheLineThroughDenseData) {
  FitCurve curve{0.0, {}, {}, {-80.0, 80.0}, {0.08, 0.08}, {}};
  for (int k = -160; k <= 160; ++k) {
    curve.measured_theta_r_deg.push_back(0.5 * k);
    curve.measured_f_r_per_sr.push_back(k % 2 == 0 ? 0.0805 : 0.0795);
    curve.residual.push_back(4.0);
  }
  const PngPixels pixels = drawn({"Fit", "", {curve}, ValueScale::linear});
  const PlotFrame frame = Panels(pixels, 0.0, 0.1, 4.0).values;
  for (double angle = -79.0; angle < 79.0; angle += 0.1)
    ASSERT_TRUE(frame.is_at(pixels, curve_colour(0), angle, 0.08)) << angle;
}

// A sine that a constant is fitted to, and a smaller one of another incidence in front.
FitPicture dense(int points) {
  FitPicture picture{"Fit", "", {}, ValueScale::linear};
  for (const double height : {0.01, 0.03}) {
    FitCurve curve{1e3 * height, {}, {}, {-80.0, 80.0}, {0.05, 0.05}, {}};
    for (int k = 0; k < points; ++k) {
      curve.measured_theta_r_deg.push_back(-80.0 + 160.0 * k / (points - 1));
      curve.residual.push_back(100.0 * height * std::sin(0.1 * curve.measured_theta_r_deg.back()));
      curve.measured_f_r_per_sr.push_back(0.05 + 0.01 * curve.residual.back());
    }
    picture.curves.push_back(curve);
  }
  return picture;
}

TEST(FitPlot, DrawsDenseSymbolsWhole) {
  const FitPicture picture = dense(2000);
  const PngPixels pixels = drawn(picture);
  const PlotFrame frame = Panels(pixels, 0.0, 0.08, 3.0).residuals;
  for (std::size_t i = 0; i < 2000; ++i) {  // those in front; off the zero line
    const double residual = picture.curves[0].residual[i];
    if (std::abs(residual) <= 0.3) continue;
    ASSERT_TRUE(frame.is_at(pixels, curve_colour(0), picture.curves[0].measured_theta_r_deg[i], residual)) << i;
  }
}

TEST(FitPlot, TakesNoLongerForSymbolsThatCannotBeToldApart) {
  const auto seconds = [](int points) {
    const FitPicture picture = dense(points);
    const auto start = std::chrono::steady_clock::now();
    (void)drawn(picture);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  EXPECT_LT(seconds(200000), 3.0 * seconds(2000));
}

TEST(FitPlot, LeavesOutAResidualThatIsNoNumber) {
  FitCurve curve = three_points(30.0, 0.08);
  curve.residual[0] = std::numeric_limits<double>::quiet_NaN();
  FitPicture picture{"Fit", "", {curve}, ValueScale::linear, ResidualKind::logarithm};
  const PngPixels pixels = drawn(picture);
  const PlotFrame frame = Panels(pixels, 0.0, 0.12, 3.0).residuals;
  EXPECT_TRUE(frame.is_at(pixels, curve_colour(0), 0.0, -3.0));
  const double middle = 0.5 * (frame.bottom + frame.top);
  EXPECT_EQ(find_near(pixels, curve_colour(0), frame.column(-60.0), middle, 0.5 * (frame.top - frame.bottom)).count, 0);
}

TEST(FitPlot, GivesTheSameBytesWhateverTheOrderOfItsCurves) {
  FitPicture picture = constants(5);
  const auto first = scratch_file("first.png"), second = scratch_file("second.png");
  draw_fit_plot(first, picture);
  std::reverse(picture.curves.begin(), picture.curves.end());
  draw_fit_plot(second, picture);
  EXPECT_EQ(bytes_of(first), bytes_of(second));
  EXPECT_FALSE(bytes_of(first).empty());
}

TEST(FitPlot, DrawsAFitWithoutResiduals) {
  FitCurve curve = three_points(0.0, 0.08);
  curve.residual = {0.0, 0.0, 0.0};
  EXPECT_GT(find_colour(drawn({"", "", {curve}}), curve_colour(0)).count, 2000);
}

TEST(FitPlot, NeedsNeitherDisplayNorXServer) {
  const auto png = scratch_file("fit.png");
  exit_in_fresh_process();
  EXPECT_EXIT(
      {
        unsetenv("DISPLAY");
        setenv("PATH", "/nonexistent", 1);
        draw_fit_plot(png, constants(3));
        std::exit(0);
      },
      testing::ExitedWithCode(0), "");
}

TEST(FitPlot, RefusesCurvesThatCannotBe) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto png = scratch_file("fit.png");
  const auto refuses = [&](const std::function<void(FitCurve&)>& spoil) {
    FitCurve curve = three_points(0.0, 0.08);
    spoil(curve);
    EXPECT_THROW(draw_fit_plot(png, {"", "", {curve}}), std::invalid_argument);
  };
  EXPECT_THROW(draw_fit_plot(png, {}), std::invalid_argument);
  EXPECT_THROW(draw_fit_plot(png, constants(most_incidences_of_a_fit + 1)), std::invalid_argument);
  refuses([](FitCurve& curve) { curve = {}; });
  refuses([](FitCurve& curve) { curve.theta_i_deg = nan; });
  refuses([](FitCurve& curve) { curve.measured_theta_r_deg[1] = nan; });
  refuses([](FitCurve& curve) { curve.measured_f_r_per_sr[1] = nan; });
  refuses([](FitCurve& curve) { curve.fitted_f_r_per_sr[1] = nan; });
  refuses([](FitCurve& curve) { curve.residual.pop_back(); });
  refuses([](FitCurve& curve) { curve.fitted_f_r_per_sr[1] = -1.0; });
  refuses([](FitCurve& curve) { std::swap(curve.fitted_theta_r_deg[0], curve.fitted_theta_r_deg[1]); });
  refuses([](FitCurve& curve) { curve.fitted_theta_r_deg.clear(), curve.fitted_f_r_per_sr.clear(); });
  EXPECT_FALSE(std::filesystem::exists(png));
}

}  // namespace
}  // namespace lrcs
