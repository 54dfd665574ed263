#pragma once
#include <vector>

#include "view/colour.h"

namespace lrcs {

struct Box;
struct Picture;
struct Point;

// A filled polygon of one colour. shape: corners in order, either way round; not convex: inside by the even-odd rule.
struct Tile {
  std::vector<Point> outline;
  Colour colour;
};

// Paints tiles into the part of a picture inside `clip`, later ones over earlier ones.
// value: 4 x 4 points a pixel, a point belongs to the last tile around it.
// laws: tiles that share an edge leave no seam and no doubled edge: what lies below does not show between them.
// domain: a tile with a corner that is not finite is not painted.
// error: 1/4 pixel an edge; half a level of colour. check: tests/view/tiles_test.cpp.
void paint_tiles(Picture& picture, const Box& clip, const std::vector<Tile>& tiles);

}  // namespace lrcs
