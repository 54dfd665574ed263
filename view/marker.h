#pragma once
#include <cstddef>
#include <vector>

#include "view/canvas.h"

namespace lrcs {

// The symbol of a measured point, centred on it. `radius`: of the disc that inks as much [pixel].
enum class MarkerShape { disc, square, triangle, diamond, cross, inverted_triangle, ring, plus };

struct Marker {
  MarkerShape shape = MarkerShape::disc;
  Colour colour = ink;
  double radius = 10.0;
  double rim = 2.0;  // white, so that neighbours and the line behind stay apart; 0: none [pixel]
};

// Shape number `curve`: eight that stay apart in print without colour, then again from the first.
[[nodiscard]] MarkerShape marker_shape(std::size_t curve);

// Later points lie over earlier ones. Nothing for a point that is not finite.
// check: tests/view/marker_test.cpp measures area and centre of ink.
void draw_markers(Canvas& canvas, const std::vector<Point>& centres, const Marker& marker);

}  // namespace lrcs
