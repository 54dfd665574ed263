#include "view/shadowing_plot.h"

#include <limits>
#include <stdexcept>

#include "plot_frame.h"

namespace lrcs {
namespace {

// Straight from `left` at -90 deg to `right` at 90 deg.
ShadowingCurve straight(double theta_i_deg, double left, double right) {
  return {theta_i_deg, {-90.0, 0.0, 90.0}, {left, 0.5 * (left + right), right}};
}

PngPixels drawn(const std::vector<ShadowingCurves>& materials) {
  const auto png = scratch_file("shadowing.png");
  draw_shadowing_plot(png, materials, "Shadowing");
  return PngPixels(png);
}

PlotFrame frame_of(const PngPixels& pixels) {
  const auto columns = ink_lines(pixels, false, 400);
  const auto rows = ink_lines(pixels, true, 1000);
  return {columns.front(), columns.back(), rows.front(), rows.back(), -90.0, 90.0, 0.0, 1.04};
}

TEST(ShadowingPlot, PutsEachCurveWhereItsValuesSay) {
  const PngPixels pixels = drawn({{"metal", {straight(0.0, 0.2, 0.8), straight(30.0, 1.0, 0.6)}}});
  EXPECT_EQ(pixels.size[0], 1600);
  EXPECT_EQ(pixels.size[1], 1000);
  const PlotFrame frame = frame_of(pixels);
  for (const double angle : {-80.0, -30.0, 30.0, 80.0}) {
    EXPECT_TRUE(frame.is_at(pixels, curve_colour(0), angle, 0.5 + 0.3 * angle / 90.0)) << angle;
    EXPECT_TRUE(frame.is_at(pixels, curve_colour(1), angle, 0.8 - 0.2 * angle / 90.0)) << angle;
  }
}

TEST(ShadowingPlot, TellsMaterialsByDashes) {
  const PngPixels pixels = drawn({{"solid", {straight(0.0, 0.8, 0.8)}}, {"dashed", {straight(0.0, 0.3, 0.3)}}});
  const PlotFrame frame = frame_of(pixels);
  const auto inked = [&](double g) {
    int count = 0;
    for (double angle = -85.0; angle <= 85.0; angle += 0.1)
      count += frame.is_at(pixels, curve_colour(0), angle, g) ? 1 : 0;
    return count / 1701.0;
  };
  EXPECT_GT(inked(0.8), 0.99);
  EXPECT_GT(inked(0.3), 0.5);
  EXPECT_LT(inked(0.3), 0.85);
}

TEST(ShadowingPlot, HasALegendOfAnglesAndOneOfMaterials) {
  const auto rows_above_frame = [](const PngPixels& pixels) {
    return find_colour(pixels, curve_colour(1)).top - frame_of(pixels).top;
  };
  const std::vector<ShadowingCurve> curves{straight(0.0, 0.2, 0.2), straight(30.0, 0.4, 0.4)};
  const double alone = rows_above_frame(drawn({{"one", curves}}));
  const double compared = rows_above_frame(drawn({{"one", curves}, {"two", curves}}));
  EXPECT_GT(alone, 10.0);
  EXPECT_NEAR(compared - alone, 48.0, 1.0);  // a row of materials below that of the angles
}

TEST(ShadowingPlot, GivesTheSameBytesTwice) {
  const std::vector<ShadowingCurves> materials{{"one", {straight(0.0, 0.2, 0.9)}}, {"two", {straight(0.0, 0.3, 0.4)}}};
  const auto first = scratch_file("first.png"), second = scratch_file("second.png");
  draw_shadowing_plot(first, materials, "G");
  draw_shadowing_plot(second, materials, "G");
  EXPECT_EQ(bytes_of(first), bytes_of(second));
  EXPECT_FALSE(bytes_of(first).empty());
}

TEST(ShadowingPlot, DrawsSevenOfManyIncidences) {
  ShadowingCurves material{"many", {}};
  for (int k = 0; k < 20; ++k) material.curves.push_back(straight(4.0 * k, 0.05 * k, 0.05 * k));
  const PngPixels pixels = drawn({material});
  const PlotFrame frame = frame_of(pixels);
  int drawn_lines = 0;
  for (int k = 0; k < 20; ++k)
    for (std::size_t colour = 0; colour < 7; ++colour)
      drawn_lines += k > 0 && frame.is_at(pixels, curve_colour(colour), 10.0, 0.05 * k) ? 1 : 0;
  EXPECT_EQ(drawn_lines, 6);  // the seventh lies on the frame
}

TEST(ShadowingPlot, RefusesCurvesThatCannotBe) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto png = scratch_file("shadowing.png");
  const ShadowingCurves good{"good", {straight(0.0, 0.2, 0.9)}};
  const std::vector<std::vector<ShadowingCurves>> wrong{{},
                                                        std::vector<ShadowingCurves>(7, good),
                                                        {{"none", {}}},
                                                        {{"empty", {{0.0, {}, {}}}}},
                                                        {{"lengths", {{0.0, {1.0}, {0.5, 0.5}}}}},
                                                        {{"above 1", {straight(0.0, 0.2, 1.1)}}},
                                                        {{"below 0", {straight(0.0, -0.2, 0.1)}}},
                                                        {{"nan", {straight(0.0, 0.2, nan)}}},
                                                        {{"angle", {straight(nan, 0.2, 0.3)}}},
                                                        {good, {"other angles", {straight(10.0, 0.2, 0.9)}}}};
  for (std::size_t i = 0; i < wrong.size(); ++i)
    EXPECT_THROW(draw_shadowing_plot(png, wrong[i], ""), std::invalid_argument) << i;
  EXPECT_FALSE(std::filesystem::exists(png));
}

}  // namespace
}  // namespace lrcs
