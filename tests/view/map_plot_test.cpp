#include "view/map_plot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/direction.h"
#include "png_pixels.h"
#include "svg_reading.h"
#include "view/plot_file.h"

namespace lrcs {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

// A plate's cos^2, seen from its front.
double cos_squared(double azimuth_deg, double elevation_deg) {
  const double c = std::max(0.0, direction_of({azimuth_deg, elevation_deg}).x());
  return c * c;
}

DirectionMap plate() {
  DirectionMap map;
  for (int azimuth = -180; azimuth <= 170; azimuth += 10) map.azimuth_deg.push_back(azimuth);
  for (int elevation = -90; elevation <= 90; elevation += 10) map.elevation_deg.push_back(elevation);
  for (const double elevation : map.elevation_deg)
    for (const double azimuth : map.azimuth_deg) map.sigma_m2.push_back(cos_squared(azimuth, elevation));
  return map;
}

// From -40 dBsm (floor) to 0 dBsm (nose-on).
const MapText plate_text{"Plate", -40.0};

Colour expected_colour(double sigma) {
  return viridis(std::clamp((10.0 * std::log10(sigma) + 40.0) / 40.0, 0.0, 1.0));
}

struct DrawnMap {
  PngPixels pixels;
  CartesianFrame frame;

  [[nodiscard]] bool is(const Colour& colour, double azimuth, double elevation) const {
    const Point at = frame.at(azimuth, elevation);
    return pixels.is(colour, static_cast<int>(at.x), static_cast<int>(at.y), 1);
  }
};

DrawnMap drawn_map(const DirectionMap& map) {
  const auto png = scratch_file("map.png");
  Canvas canvas = plot_canvas(png, 1600, 1000);
  const CartesianFrame frame = draw_map_plot(canvas, map, plate_text);
  write_plot(png, canvas);
  return {PngPixels(png), frame};
}

TEST(MapPlot, ColoursEachDirectionByItsSigma) {
  const DrawnMap map = drawn_map(plate());
  for (int azimuth = -170; azimuth <= 160; azimuth += 10)
    for (int elevation = -80; elevation <= 80; elevation += 10)
      EXPECT_TRUE(map.is(expected_colour(cos_squared(azimuth, elevation)), azimuth, elevation))
          << azimuth << " " << elevation;
  EXPECT_FALSE(map.is(expected_colour(1.0), 40.0, 0.0));
}

TEST(MapPlot, PutsTheEdgesOfCellsHalfWay) {
  const DrawnMap map = drawn_map(plate());
  const Colour at_40 = expected_colour(cos_squared(40, 0)), at_50 = expected_colour(cos_squared(50, 0));
  const double pixel = 365.0 / (map.frame.box.high.x - map.frame.box.low.x);  // [deg]
  EXPECT_TRUE(map.is(at_40, 45.0 - 2.0 * pixel, 0.0));
  EXPECT_TRUE(map.is(at_50, 45.0 + 2.0 * pixel, 0.0));
  EXPECT_TRUE(map.is(at_40, 40.0, 4.0));
  EXPECT_FALSE(map.is(at_40, 40.0, 6.0));
}

TEST(MapPlot, SpansItsCellsButNothingBeyondThePoles) {
  const CartesianFrame frame = drawn_map(plate()).frame;
  EXPECT_EQ(frame.x.low, -185.0);
  EXPECT_EQ(frame.x.high, 175.0);
  EXPECT_EQ(frame.y.low, -90.0);
  EXPECT_EQ(frame.y.high, 90.0);
}

TEST(MapCells, OfUnevenAnglesMeetHalfWay) {
  const DirectionMap map{{0.0, 10.0, 40.0}, {-20.0, 0.0}, {1.0, 2.0, 3.0, 4.0, 5.0, 6.0}};
  const auto cells = map_cells(map);
  ASSERT_EQ(cells.size(), 6U);
  EXPECT_EQ(cells[0].west, -5.0);
  EXPECT_EQ(cells[0].east, 5.0);
  EXPECT_EQ(cells[1].east, 25.0);
  EXPECT_EQ(cells[2].east, 55.0);
  EXPECT_EQ(cells[0].south, -30.0);
  EXPECT_EQ(cells[5].north, 10.0);
  EXPECT_EQ(cells[5].sigma_m2, 6.0);
}

TEST(MapPlot, LeavesMissingDirectionsWhiteAndSaysSo) {
  DirectionMap map = plate();
  map.sigma_m2[9 * 36 + 20] = missing;  // azimuth 20, elevation 0
  const DrawnMap picture = drawn_map(map);
  EXPECT_TRUE(picture.is(white, 18.0, 2.0));  // off the grid's lines
  EXPECT_FALSE(picture.is(white, 28.0, 2.0));
  Canvas canvas(1600, 1000, Recording::shapes);
  draw_map_plot(canvas, map, plate_text);
  const auto texts = read_back(canvas).texts();
  for (const char* words : {"Plate", "azimuth [deg]", "elevation [deg]", "LRCS [dBsm]", "−40", "0",
                            "Darkest: LRCS is 0 or below −40 dBsm; white: not computed"})
    EXPECT_NE(std::find(texts.begin(), texts.end(), words), texts.end()) << words;
}

TEST(MapPlot, DrawsAMapThatIsZeroThroughout) {
  const DirectionMap dark{{0.0, 10.0}, {0.0, 10.0}, {0.0, 0.0, 0.0, 0.0}};
  Canvas canvas(1600, 1000, Recording::shapes);
  const CartesianFrame frame = draw_map_plot(canvas, dark, {"dark"});
  EXPECT_EQ(frame.x.low, -5.0);
  EXPECT_NE(canvas.svg().find("LRCS is 0 m² in every direction"), std::string::npos);
}

TEST(MapPlot, RefusesMapsThatCannotBe) {
  const std::vector<DirectionMap> wrong{{{0.0}, {0.0, 1.0}, {1.0, 1.0}},
                                        {{0.0, 1.0}, {0.0}, {1.0, 1.0}},
                                        {{1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0, 1.0, 1.0}},
                                        {{0.0, 1.0}, {0.0, 91.0}, {1.0, 1.0, 1.0, 1.0}},
                                        {{0.0, 1.0}, {0.0, 1.0}, {1.0, 1.0, 1.0}},
                                        {{0.0, 1.0}, {0.0, 1.0}, {1.0, 1.0, 1.0, -1.0}}};
  for (const DirectionMap& map : wrong) {
    Canvas canvas(1600, 1000);
    EXPECT_THROW(draw_map_plot(canvas, map, {"wrong"}), std::invalid_argument);
  }
}

}  // namespace
}  // namespace lrcs
