#include "view/marker.h"

#include <array>
#include <cmath>
#include <numbers>

namespace lrcs {
namespace {

using std::numbers::pi;

// The corners of a regular polygon, the first at angle `first` [rad].
std::vector<Point> regular(const Point& centre, int corners, double radius, double first) {
  std::vector<Point> outline;
  for (int k = 0; k < corners; ++k) {
    const double angle = first + 2.0 * pi * k / corners;
    outline.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return outline;
}

// An upright cross with arms of half the length and thickness, turned by an angle [rad].
std::vector<Point> cross(const Point& centre, double reach, double half, double turn) {
  std::vector<Point> outline;
  for (int arm = 0; arm < 4; ++arm) {
    const double c = std::cos(turn + 0.5 * pi * arm), s = std::sin(turn + 0.5 * pi * arm);
    for (const Point& p : {Point{half, -half}, Point{reach, -half}, Point{reach, half}})
      outline.push_back({centre.x + c * p.x - s * p.y, centre.y + s * p.x + c * p.y});
  }
  return outline;
}

// The marker's outline, all around by `rim` larger [pixel].
std::vector<Point> outline_of(const Marker& marker, const Point& centre, double rim) {
  const double r = marker.radius;
  const double square = r * std::sqrt(0.5 * pi);                             // half a diagonal
  const double triangle = r * std::sqrt(4.0 * pi / (3.0 * std::sqrt(3.0)));  // from centre to corner
  const double reach = 1.5 * r, half = 0.32 * r;
  switch (marker.shape) {
    case MarkerShape::square:
      return regular(centre, 4, square + std::numbers::sqrt2 * rim, 0.25 * pi);
    case MarkerShape::diamond:
      return regular(centre, 4, square + std::numbers::sqrt2 * rim, 0.0);
    case MarkerShape::triangle:
      return regular(centre, 3, triangle + 2.0 * rim, 0.5 * pi);
    case MarkerShape::inverted_triangle:
      return regular(centre, 3, triangle + 2.0 * rim, -0.5 * pi);
    case MarkerShape::cross:
      return cross(centre, reach + rim, half + rim, 0.25 * pi);
    case MarkerShape::plus:
      return cross(centre, reach + rim, half + rim, 0.0);
    case MarkerShape::disc:
      return regular(centre, 40, r + rim, 0.0);
    case MarkerShape::ring:
      return regular(centre, 40, 1.2 * r + rim, 0.0);
  }
  return {};
}

// What the marker inks: a ring's outline goes once round outside, then once inside.
std::vector<Point> ink_of(const Marker& marker, const Point& centre) {
  std::vector<Point> outline = outline_of(marker, centre, 0.0);
  if (marker.shape != MarkerShape::ring) return outline;
  const std::vector<Point> hole = regular(centre, 40, marker.radius * std::sqrt(1.2 * 1.2 - 0.75), 0.0);
  outline.push_back(outline.front());
  outline.insert(outline.end(), hole.begin(), hole.end());
  outline.push_back(hole.front());
  return outline;
}

}  // namespace

MarkerShape marker_shape(std::size_t curve) {
  using enum MarkerShape;
  constexpr std::array shapes{disc, square, triangle, diamond, cross, inverted_triangle, ring, plus};
  return shapes[curve % shapes.size()];
}

void draw_markers(Canvas& canvas, const std::vector<Point>& centres, const Marker& marker) {
  for (const Point& centre : centres) {
    std::vector<Tile> tiles;
    if (marker.rim > 0.0) tiles.push_back({outline_of(marker, centre, marker.rim), white});
    tiles.push_back({ink_of(marker, centre), marker.colour});
    canvas.tiles(tiles);
  }
}

}  // namespace lrcs
