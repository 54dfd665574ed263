#include "view/brdf_plot.h"

#include <limits>
#include <stdexcept>

#include "png_pixels.h"

namespace lrcs {
namespace {

BrdfCurve lobe(double theta_i_deg, double width_deg, double floor) {
  BrdfCurve curve{theta_i_deg, {}, {}};
  for (int angle = -90; angle <= 90; ++angle) {
    const double distance = (angle - theta_i_deg) / width_deg;
    curve.theta_r_deg.push_back(angle);
    curve.f_r_per_sr.push_back(floor + 0.3 * std::exp(-distance * distance));
  }
  return curve;
}

TEST(BrdfPlot, DrawsEachIncidenceInItsColour) {
  const auto png = scratch_file("brdf.png");
  draw_brdf_plot(png, {lobe(0.0, 15.0, 0.05), lobe(30.0, 15.0, 0.05), lobe(60.0, 15.0, 0.05)}, "metal skin");
  const PngPixels pixels(png);
  EXPECT_EQ(pixels.size[0], 1600);
  EXPECT_EQ(pixels.size[1], 1000);
  for (std::size_t curve = 0; curve < 3; ++curve) EXPECT_GT(find_colour(pixels, curve_colour(curve)).count, 2000);
}

// A Gaussian lobe is far from a parabola on a linear axis, and one on a logarithmic axis.
double height_at_half_way(double floor) {
  const auto png = scratch_file("brdf.png");
  draw_brdf_plot(png, {lobe(0.0, 36.0, floor)}, "lobe");
  const PngPixels pixels(png);
  const Found line = find_colour(pixels, curve_colour(0));
  const int column = line.left + (line.right - line.left) * 3 / 4;  // theta_r = 45 deg
  int row = line.top;
  while (!pixels.is(curve_colour(0), column, row)) --row;
  return (row - line.bottom) / static_cast<double>(line.top - line.bottom);
}

TEST(BrdfPlot, TakesALogarithmicAxisForALargeRatioOnly) {
  const double ratio = std::exp(-45.0 * 45.0 / (36.0 * 36.0));
  const double end = std::exp(-90.0 * 90.0 / (36.0 * 36.0));
  EXPECT_NEAR(height_at_half_way(0.0), 0.75, 0.02);  // log of a Gaussian: 1 - (45/90)^2
  EXPECT_NEAR(height_at_half_way(0.05), (ratio - end) / (1.0 - end), 0.02);
}

TEST(BrdfPlot, BreaksWhereTheBrdfIsInfinite) {
  BrdfCurve curve = lobe(0.0, 30.0, 0.1);
  curve.f_r_per_sr.front() = std::numeric_limits<double>::infinity();
  curve.f_r_per_sr.back() = std::numeric_limits<double>::quiet_NaN();
  const auto png = scratch_file("brdf.png");
  draw_brdf_plot(png, {curve}, "grazing");
  EXPECT_GT(find_colour(PngPixels(png), curve_colour(0)).count, 2000);
}

TEST(BrdfPlot, ComparesMaterialsByDashes) {
  const std::vector<BrdfCurve> curves{lobe(0.0, 15.0, 0.05), lobe(30.0, 15.0, 0.05)};
  const auto solid = scratch_file("solid.png"), dashed = scratch_file("dashed.png");
  draw_brdf_plot(solid, curves, "one");
  draw_brdf_comparison(dashed, {{"one", {lobe(0.0, 15.0, 0.05)}}, {"two", {lobe(0.0, 5.0, 0.01)}}}, "two");
  const int one = find_colour(PngPixels(solid), curve_colour(0)).count;
  const int both = find_colour(PngPixels(dashed), curve_colour(0)).count;
  EXPECT_GT(both, 1.3 * one);
  EXPECT_LT(both, 2.0 * one);
}

TEST(BrdfPlot, RefusesMaterialsThatCannotBeCompared) {
  const auto png = scratch_file("brdf.png");
  const BrdfCurves good{"good", {lobe(0.0, 15.0, 0.05)}};
  EXPECT_THROW(draw_brdf_comparison(png, {}, ""), std::invalid_argument);
  EXPECT_THROW(draw_brdf_comparison(png, std::vector<BrdfCurves>(7, good), ""), std::invalid_argument);
  EXPECT_THROW(draw_brdf_comparison(png, {good, {"other", {lobe(10.0, 15.0, 0.05)}}}, ""), std::invalid_argument);
  EXPECT_THROW(draw_brdf_comparison(png, {good, {"none", {}}}, ""), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(png));
}

TEST(BrdfPlot, RefusesCurvesThatCannotBe) {
  const auto png = scratch_file("brdf.png");
  EXPECT_THROW(draw_brdf_plot(png, {}, ""), std::invalid_argument);
  EXPECT_THROW(draw_brdf_plot(png, {{0.0, {0.0, 1.0}, {1.0}}}, ""), std::invalid_argument);
  EXPECT_THROW(draw_brdf_plot(png, {{0.0, {0.0}, {-1.0}}}, ""), std::invalid_argument);
}

}  // namespace
}  // namespace lrcs
