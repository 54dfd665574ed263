#include "view/sphere_plot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "png_pixels.h"
#include "svg_reading.h"
#include "view/plot_file.h"

namespace lrcs {
namespace {

// 1 m^2 nose-on, 0 tail-on, and every value between on one cone only: cos^4 of half the angle from the nose.
double cone(const AspectAngles& angles) {
  const double c = 0.5 * (1.0 + direction_of(angles).x());
  return c * c;
}

DirectionMap all_around() {
  DirectionMap map;
  for (int azimuth = 0; azimuth < 360; azimuth += 5) map.azimuth_deg.push_back(azimuth);
  for (int elevation = -90; elevation <= 90; elevation += 5) map.elevation_deg.push_back(elevation);
  for (const double elevation : map.elevation_deg)
    for (const double azimuth : map.azimuth_deg) map.sigma_m2.push_back(cone({azimuth, elevation}));
  return map;
}

// The same with one direction only.
DirectionMap alone(const AspectAngles& angles) {
  DirectionMap map = all_around();
  for (std::size_t e = 0; e < map.elevation_deg.size(); ++e)
    for (std::size_t a = 0; a < map.azimuth_deg.size(); ++a)
      if (map.azimuth_deg[a] != angles.azimuth_deg || map.elevation_deg[e] != angles.elevation_deg)
        map.sigma_m2[e * map.azimuth_deg.size() + a] = std::numeric_limits<double>::quiet_NaN();
  return map;
}

double area_of(const std::vector<Tile>& tiles) {
  double area = 0.0;
  for (const Tile& tile : tiles) {
    double twice = 0.0;
    for (std::size_t i = 0; i < tile.outline.size(); ++i) {
      const Point &p = tile.outline[i], &q = tile.outline[(i + 1) % tile.outline.size()];
      twice += p.x * q.y - q.x * p.y;
    }
    area += 0.5 * std::abs(twice);
  }
  return area;
}

const DecibelRange cone_range = map_range(all_around(), -40.0);

TEST(SphereTiles, CoverTheDiscOnce) {
  for (const AspectAngles from : {AspectAngles{0, 0}, {30, 25}, {217, -71}, {0, 90}, {45, -90}}) {
    const SphereView view = sphere_view({0.0, 0.0}, 100.0, from);
    const auto tiles = sphere_tiles(all_around(), cone_range, view);
    EXPECT_NEAR(area_of(tiles), std::numbers::pi * 1e4, 1e-3 * std::numbers::pi * 1e4) << from.azimuth_deg;
    for (const Tile& tile : tiles)
      for (const Point& p : tile.outline) EXPECT_LE(std::hypot(p.x, p.y), 100.0 + 1e-9);
  }
}

TEST(SphereTiles, ShowADirectionThatFacesTheViewerAndHideTheOpposite) {
  const SphereView view = sphere_view({500.0, 400.0}, 300.0, {30, 25});
  const auto shown = sphere_tiles(alone({40, 20}), cone_range, view);
  ASSERT_EQ(shown.size(), 1U);
  EXPECT_EQ(rgb_of(shown[0].colour), rgb_of(map_colour(cone_range, cone({40, 20}))));
  // Its area is cos(elevation) d azimuth d elevation, times the cosine toward the viewer.
  const double toward = view.to_viewer.dot(direction_of({40, 20}));
  const double area = 9e4 * std::cos(20 * degree) * std::pow(5 * degree, 2) * toward;
  EXPECT_NEAR(area_of(shown), area, 2e-3 * area);
  EXPECT_TRUE(sphere_tiles(alone({220, -20}), cone_range, view).empty());
}

TEST(SphereTiles, CutADirectionAtTheRim) {
  const SphereView view = sphere_view({0.0, 0.0}, 1000.0, {0, 0});
  // From azimuth 87.5 deg, seen from the side, to the rim.
  const double area = 1e6 * (1.0 - std::cos(2.5 * degree)) * 2.0 * std::sin(2.5 * degree);
  EXPECT_NEAR(area_of(sphere_tiles(alone({90, 0}), cone_range, view)), area, 1e-3 * area);
}

TEST(SphereView, HasUpUpAndAzimuthGrowingToTheRight) {
  const SphereView view = sphere_view({0.0, 0.0}, 1.0, {0, 0});
  EXPECT_NEAR(view.at(Vec3::UnitY()).x, 1.0, 1e-15);
  EXPECT_NEAR(view.at(Vec3::UnitZ()).y, 1.0, 1e-15);
  EXPECT_NEAR(view.at(Vec3::UnitX()).x, 0.0, 1e-15);
  EXPECT_TRUE(view.shows(Vec3::UnitX()));
  EXPECT_FALSE(view.shows(-Vec3::UnitX()));
  EXPECT_NEAR(view.right.cross(view.up).dot(view.to_viewer), 1.0, 1e-15);
}

TEST(SpherePlot, ColoursEachDirectionOnTheSphereThatShowsIt) {
  const auto png = scratch_file("sphere.png");
  Canvas canvas = plot_canvas(png, 1600, 1000);
  const SpherePair spheres = draw_sphere_plot(canvas, all_around(), {30, 25}, {"cone", -40.0});
  write_plot(png, canvas);
  const PngPixels pixels(png);
  int on_front = 0, on_back = 0;
  // Off the lines at multiples of 30 deg.
  for (int azimuth = 15; azimuth < 360; azimuth += 30)
    for (int elevation = -75; elevation <= 75; elevation += 30) {
      const AspectAngles angles{static_cast<double>(azimuth), static_cast<double>(elevation)};
      const Vec3 direction = direction_of(angles);
      const bool is_front = spheres.front.to_viewer.dot(direction) > 0.0;
      const SphereView& view = is_front ? spheres.front : spheres.back;
      // Near the rim cells are narrower than the outline.
      if (view.to_viewer.dot(direction) < 0.25) continue;
      const Point at = view.at(direction);
      // The name of an axis may lie there.
      if (pixels.is(white, static_cast<int>(at.x), static_cast<int>(at.y), 90)) continue;
      EXPECT_TRUE(pixels.is(map_colour(cone_range, cone(angles)), static_cast<int>(at.x), static_cast<int>(at.y), 1))
          << azimuth << " " << elevation;
      ++(is_front ? on_front : on_back);
    }
  EXPECT_GE(on_front, 20);
  EXPECT_GE(on_back, 20);
}

TEST(SpherePlot, NamesDirectionsAxesAndUnits) {
  Canvas canvas(1600, 1000, Recording::shapes);
  draw_sphere_plot(canvas, all_around(), {200, -10}, {"cone", -40.0});
  const auto texts = read_back(canvas).texts();
  for (const char* words :
       {"cone", "seen from azimuth 200°, elevation −10°", "seen from azimuth 20°, elevation 10°", "LRCS [dBsm]",
        "x: forward, y: left, z: up; lines every 30°", "Darkest: LRCS is 0 or below −40 dBsm"})
    EXPECT_EQ(std::count(texts.begin(), texts.end(), words), 1) << words;
  for (const char* axis : {"x", "y", "z"}) EXPECT_EQ(std::count(texts.begin(), texts.end(), axis), 2) << axis;
}

TEST(Graticule, LiesOnTheHalfThatFacesTheViewer) {
  const SphereView view = sphere_view({0.0, 0.0}, 1.0, {0, 90});
  const auto lines = graticule(view, 30.0);
  ASSERT_EQ(lines.size(), 12U + 5U);
  // From above, meridians are straight and the parallels of the lower half hidden.
  int drawn = 0;
  for (std::size_t parallel = 12; parallel < lines.size(); ++parallel) {
    const double elevation = -60.0 + 30.0 * (static_cast<double>(parallel) - 12.0);
    for (const Point& p : lines[parallel]) {
      if (!std::isfinite(p.x)) continue;
      ++drawn;
      EXPECT_GE(elevation, 0.0);
      EXPECT_NEAR(std::hypot(p.x, p.y), std::cos(elevation * degree), 1e-12);
    }
  }
  EXPECT_GE(drawn, 2 * 361);
}

}  // namespace
}  // namespace lrcs
