#pragma once
#include <vector>

#include "view/colour.h"
#include "view/decibel_cut.h"

namespace lrcs {

// LRCS over a grid of directions.
// shape: sigma_m2 has azimuths x elevations entries, azimuth runs fastest; NaN: no such direction [m^2].
// domain: angles rise; elevations in [-90, 90]; each axis has two angles or more; sigma >= 0. Else
// std::invalid_argument where it is drawn.
struct DirectionMap {
  std::vector<double> azimuth_deg;
  std::vector<double> elevation_deg;
  std::vector<double> sigma_m2;
};

// A direction with its surroundings.
// value: its edges lie half way to the neighbours, at the ends of the grid as far out as in, never beyond a pole.
struct MapCell {
  double west, east, south, north;  // [deg]
  double sigma_m2;
};

// The cells of the directions that are there, row by row.
[[nodiscard]] std::vector<MapCell> map_cells(const DirectionMap& map);

// The dBsm that its colours span.
[[nodiscard]] DecibelRange map_range(const DirectionMap& map, std::optional<double> floor_dbsm);

// Viridis, straight in dBsm; what lies below the range has the darkest colour.
[[nodiscard]] Colour map_colour(const DecibelRange& range, double sigma_m2);

// What a plot says of its colours: "" or a sentence.
[[nodiscard]] std::string map_note(const DirectionMap& map, const DecibelRange& range);

// Room that the bar and its words take at the right end of the canvas [pixel].
inline constexpr double map_bar_room = 270.0;

// The bar of the colours in that room, with its unit.
void draw_map_bar(Canvas& canvas, double bottom, double top, const DecibelRange& range);

}  // namespace lrcs
