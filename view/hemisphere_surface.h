#pragma once
#include <vector>

#include "view/brdf_surface.h"
#include "view/hemisphere_view.h"
#include "view/tiles.h"

namespace lrcs {

// The surface of a function over the disc of directions, as tiles to be painted in order: far ones first.
// value: height and colour (viridis) are value / full_scale. Each cell of the grid is a tile, or several where it is
// steep, with lines along
//   multiples of 10 deg in theta_r and of 30 deg in phi; below the near half of the rim a grey wall down to 0.
// error: a cell is painted before what is nearer by its middle: exact for cells as small as the surface's features.
[[nodiscard]] std::vector<Tile> hemisphere_surface(const HemisphereValues& values, double full_scale,
                                                   const HemisphereView& view);

}  // namespace lrcs
