#pragma once
#include "view/cartesian_frame.h"
#include "view/direction_map.h"

namespace lrcs {

struct MapText {
  std::string title;
  std::optional<double> floor_dbsm = {};  // of the colours; none: about 60 dB below the highest direction
};

// Draws LRCS in dBsm over azimuth and elevation, as colours.
// value: each direction's cell (view/direction_map.h) has its colour; where no direction is, the sheet stays white. The
//   plot says what the darkest colour stands for.
// domain: as DirectionMap; the floor lies below the highest direction.
// check: tests/view/map_plot_test.cpp finds the colours of a closed form.
CartesianFrame draw_map_plot(Canvas& canvas, const DirectionMap& map, const MapText& text);

// The same into a PNG or SVG, 1600 x 1000 pixels.
void draw_map_plot(const std::filesystem::path& file, const DirectionMap& map, const MapText& text);

}  // namespace lrcs
