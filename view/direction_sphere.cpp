#include "view/direction_sphere.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lrcs {
namespace {

constexpr double longest_step = 2.0;  // of what is drawn straight [deg]

int steps_over(double span_deg) {
  return std::max(1, static_cast<int>(std::ceil(span_deg / longest_step - 1e-9)));
}

// Round the cell's edges.
std::vector<Vec3> outline_of(const MapCell& cell) {
  std::vector<Vec3> outline;
  const auto walk = [&](double azimuth, double to_azimuth, double elevation, double to_elevation) {
    const int steps = steps_over(std::max(std::abs(to_azimuth - azimuth), std::abs(to_elevation - elevation)));
    for (int step = 0; step < steps; ++step) {
      const double share = static_cast<double>(step) / steps;
      outline.push_back(
          direction_of({std::lerp(azimuth, to_azimuth, share), std::lerp(elevation, to_elevation, share)}));
    }
  };
  walk(cell.west, cell.east, cell.south, cell.south);
  walk(cell.east, cell.east, cell.south, cell.north);
  walk(cell.east, cell.west, cell.north, cell.north);
  walk(cell.west, cell.west, cell.north, cell.south);
  return outline;
}

// What of the outline faces the viewer. Where it crosses the rim it gets a point there.
std::vector<Point> facing(const std::vector<Vec3>& outline, const SphereView& view) {
  std::vector<Point> seen;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec3 &p = outline[i], &next = outline[(i + 1) % outline.size()];
    if (view.shows(p)) seen.push_back(view.at(p));
    if (view.shows(p) == view.shows(next)) continue;
    const double depth = view.to_viewer.dot(p), next_depth = view.to_viewer.dot(next);
    seen.push_back(view.at((p + (next - p) * (depth / (depth - next_depth))).normalized()));
  }
  return seen;
}

// The cell in pieces no longer than a step: at the rim a long one would be cut off straight.
std::vector<MapCell> pieces_of(const MapCell& cell) {
  const int columns = steps_over(cell.east - cell.west), rows = steps_over(cell.north - cell.south);
  std::vector<MapCell> pieces;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const auto x = [&](int k) { return std::lerp(cell.west, cell.east, static_cast<double>(k) / columns); };
      const auto y = [&](int k) { return std::lerp(cell.south, cell.north, static_cast<double>(k) / rows); };
      pieces.push_back({x(column), x(column + 1), y(row), y(row + 1), cell.sigma_m2});
    }
  return pieces;
}

}  // namespace

SphereView sphere_view(const Point& centre, double radius, const AspectAngles& from) {
  return {centre, radius, along_azimuth(from), along_elevation(from), direction_of(from)};
}

std::vector<Tile> sphere_tiles(const DirectionMap& map, const DecibelRange& range, const SphereView& view) {
  std::vector<Tile> tiles;
  const auto add = [&](const std::vector<Vec3>& outline, const Colour& colour) {
    std::vector<Point> seen = facing(outline, view);
    if (seen.size() > 2) tiles.push_back({std::move(seen), colour});
  };
  for (const MapCell& cell : map_cells(map)) {
    const std::vector<Vec3> outline = outline_of(cell);
    const auto shows = [&](const Vec3& p) { return view.shows(p); };
    const bool whole = std::all_of(outline.begin(), outline.end(), shows);
    const bool hidden = std::none_of(outline.begin(), outline.end(), shows);
    const Colour colour = map_colour(range, cell.sigma_m2);
    if (whole) add(outline, colour);
    if (whole || hidden) continue;
    for (const MapCell& piece : pieces_of(cell)) add(outline_of(piece), colour);
  }
  return tiles;
}

std::vector<std::vector<Point>> graticule(const SphereView& view, double step_deg) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::vector<Point>> lines;
  const auto add_point = [&](const AspectAngles& angles) {
    const Vec3 p = direction_of(angles);
    lines.back().push_back(view.shows(p) ? view.at(p) : Point{nan, nan});
  };
  for (double azimuth = 0.0; azimuth < 360.0; azimuth += step_deg) {
    lines.emplace_back();
    for (double elevation = -90.0; elevation <= 90.0; elevation += 1.0) add_point({azimuth, elevation});
  }
  for (double elevation = -90.0 + step_deg; elevation < 90.0; elevation += step_deg) {
    lines.emplace_back();
    for (double azimuth = 0.0; azimuth <= 360.0; azimuth += 1.0) add_point({azimuth, elevation});
  }
  return lines;
}

}  // namespace lrcs
