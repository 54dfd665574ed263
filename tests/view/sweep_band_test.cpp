// Curves and bands of sweep plots, read back from SVG.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "svg_reading.h"
#include "view/decibel_cut.h"
#include "view/sweep_plot.h"

namespace lrcs {
namespace {

double decibels(double sigma) {
  return 10.0 * std::log10(sigma);
}

// sigma = 2 + cos(azimuth), off by at most a part of it.
Curve cosine(double relative) {
  Curve curve{"cosine", {}, {}};
  for (int angle = 0; angle <= 180; angle += 2) {
    curve.angle_deg.push_back(angle);
    curve.sigma_m2.push_back(2.0 + std::cos(angle * 0.0174532925199433));
    curve.bound_m2.push_back(relative * curve.sigma_m2.back());
  }
  return curve;
}

Canvas drawn_curves(const std::vector<Curve>& curves, const PlotText& text, CartesianFrame* frame = nullptr) {
  Canvas canvas(1600, 1000, Recording::shapes);
  const CartesianFrame ruled = draw_sweep_plot(canvas, curves, text);
  if (frame != nullptr) *frame = ruled;
  return canvas;
}

const PlotText plain{"Title", "azimuth [deg]"};

bool holds(const std::vector<std::string>& texts, const std::string& words) {
  return std::find(texts.begin(), texts.end(), words) != texts.end();
}

TEST(SweepSvg, HoldsTheCurvesPointsWhereTheFrameSays) {
  CartesianFrame frame;
  Curve curve = cosine(0.0);
  const SvgReading svg = read_back(drawn_curves({curve}, plain, &frame));
  const auto lines = svg.named("path", "stroke", hex_of(curve_colour(0)));
  ASSERT_EQ(lines.size(), 1U);
  const auto points = svg.points(lines[0]);
  ASSERT_EQ(points.size(), curve.angle_deg.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point expected = frame.at(curve.angle_deg[i], decibels(curve.sigma_m2[i]));
    EXPECT_NEAR(points[i].x, expected.x, 1e-3);
    EXPECT_NEAR(points[i].y, expected.y, 1e-3);
  }
  for (const char* words : {"Title", "azimuth [deg]", "LRCS [dBsm]", "90"})
    EXPECT_TRUE(holds(svg.texts(), words)) << words;
}

TEST(SweepBand, LiesFromSigmaLessItsBoundToSigmaAndItsBound) {
  CartesianFrame frame;
  const Curve curve = cosine(0.3);
  const SvgReading svg = read_back(drawn_curves({curve}, plain, &frame));
  const auto bands = svg.named("polygon", "fill", hex_of(curve_colour(0)));
  ASSERT_EQ(bands.size(), 1U);
  EXPECT_LT(SvgReading::number(bands[0], "fill-opacity"), 0.5);
  const auto points = svg.points(bands[0]);
  const std::size_t n = curve.angle_deg.size();
  ASSERT_EQ(points.size(), 2 * n);
  for (std::size_t i = 0; i < n; ++i) {
    const double sigma = curve.sigma_m2[i];
    const Point high = frame.at(curve.angle_deg[i], decibels(1.3 * sigma));
    const Point low = frame.at(curve.angle_deg[i], decibels(0.7 * sigma));
    EXPECT_NEAR(points[i].y, high.y, 1e-3);
    EXPECT_NEAR(points[i].x, high.x, 1e-3);
    EXPECT_NEAR(points[2 * n - 1 - i].y, low.y, 1e-3);
    EXPECT_NEAR(points[2 * n - 1 - i].x, low.x, 1e-3);
  }
  EXPECT_TRUE(holds(svg.texts(), "Band: bound (LRCS − bound to LRCS + bound)"));
  EXPECT_LE(decibels(1.3 * 3.0), frame.y.high);
}

TEST(SweepBand, ReachesTheFloorWhereTheBoundIsAsLargeAsSigma) {
  CartesianFrame frame;
  Curve curve = cosine(0.1);
  curve.bound_m2[10] = 5.0;
  const SvgReading svg = read_back(drawn_curves({curve}, plain, &frame));
  const auto points = svg.points(svg.named("polygon", "fill", hex_of(curve_colour(0))).at(0));
  EXPECT_NEAR(points[points.size() - 11].y, frame.box.low.y, 1e-3);
}

TEST(SweepBand, OfAnExactSweepChangesNothing) {
  const Canvas with = drawn_curves({cosine(1e-12)}, plain);
  Curve curve = cosine(0.0);
  curve.bound_m2.clear();
  EXPECT_EQ(with.svg(), drawn_curves({curve}, plain).svg());
  EXPECT_EQ(with.svg().find("Band"), std::string::npos);
}

TEST(SweepBand, OfOnePercentShowsOnAFlatCurve) {
  Curve curve = cosine(0.0);
  for (std::size_t i = 0; i < curve.sigma_m2.size(); ++i) {
    curve.sigma_m2[i] = 8.0 + 0.5 * curve.sigma_m2[i];
    curve.bound_m2[i] = 0.01 * curve.sigma_m2[i];
  }
  const SvgReading svg = read_back(drawn_curves({curve}, plain));
  const auto points = svg.points(svg.named("polygon", "fill", hex_of(curve_colour(0))).at(0));
  const double line = SvgReading::number(svg.named("path", "stroke", hex_of(curve_colour(0))).at(0), "stroke-width");
  EXPECT_GT(points.front().y - points.back().y, 4.0 * line);
}

TEST(SweepBand, IsTheCurvesOwnColour) {
  const SvgReading svg = read_back(drawn_curves({cosine(0.2), cosine(0.3)}, plain));
  EXPECT_EQ(svg.named("polygon", "fill", hex_of(curve_colour(0))).size(), 1U);
  EXPECT_EQ(svg.named("polygon", "fill", hex_of(curve_colour(1))).size(), 1U);
}

// Radii of a band about a constant.
TEST(PolarBand, LiesBetweenTwoCirclesAtItsEdges) {
  Curve curve{"constant", {}, {}, {}};
  for (int angle = 0; angle < 360; angle += 10) {
    curve.angle_deg.push_back(angle);
    curve.sigma_m2.push_back(1.0);
    curve.bound_m2.push_back(0.5);
  }
  Canvas canvas(1200, 1200, Recording::shapes);
  draw_polar_plot(canvas, {curve}, {"", "azimuth [deg]", CutAngle::azimuth, -20.0});
  const SvgReading svg = read_back(canvas);
  const auto rim = svg.named("circle", "stroke", hex_of(ink));
  ASSERT_EQ(rim.size(), 1U);
  const double x = SvgReading::number(rim[0], "cx"), y = 1200.0 - SvgReading::number(rim[0], "cy");
  const auto bands = svg.named("polygon", "fill", hex_of(curve_colour(0)));
  ASSERT_EQ(bands.size(), 1U);
  const auto points = svg.points(bands[0]);
  // The rim is at 5 dBsm, the centre at -20 dBsm.
  const double radius = SvgReading::number(rim[0], "r");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double sigma = i < points.size() / 2 ? 1.5 : 0.5;
    EXPECT_NEAR(std::hypot(points[i].x - x, points[i].y - y), radius * (decibels(sigma) + 20.0) / 25.0, 2e-3);
  }
}

TEST(SweepFloor, IsWhereItWasAskedFor) {
  CartesianFrame frame;
  PlotText text = plain;
  text.floor_dbsm = 1.7;
  const SvgReading svg = read_back(drawn_curves({cosine(0.0)}, text, &frame));
  EXPECT_EQ(frame.y.low, 1.7);
  EXPECT_GE(frame.y.high, decibels(3.0));
  EXPECT_TRUE(holds(svg.texts(), "No line where LRCS is 0 or below 1.7 dBsm"));
  text.floor_dbsm = 5.0;
  EXPECT_THROW(drawn_curves({cosine(0.0)}, text), std::invalid_argument);
}

TEST(SweepBand, ThatCannotBeIsRefused) {
  Curve curve = cosine(0.1);
  curve.bound_m2.pop_back();
  EXPECT_THROW(drawn_curves({curve}, plain), std::invalid_argument);
  curve.bound_m2.push_back(-1.0);
  EXPECT_THROW(drawn_curves({curve}, plain), std::invalid_argument);
}

}  // namespace
}  // namespace lrcs
