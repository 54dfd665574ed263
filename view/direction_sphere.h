#pragma once
#include "base/direction.h"
#include "view/direction_map.h"

namespace lrcs {

// A sphere of directions on a canvas, seen from far away.
// frame: z up on the paper; a direction lies where its tip on the sphere does. Straight from above or below up is where
//   elevation grows at the given azimuth.
struct SphereView {
  Point centre;
  double radius;              // [pixel]
  Vec3 right, up, to_viewer;  // unit vectors of the body frame

  [[nodiscard]] Point at(const Vec3& p) const {
    return {centre.x + radius * right.dot(p), centre.y + radius * up.dot(p)};
  }
  [[nodiscard]] bool shows(const Vec3& direction) const { return to_viewer.dot(direction) >= 0.0; }
};
[[nodiscard]] SphereView sphere_view(const Point& centre, double radius, const AspectAngles& from);

// The cells of the map on the half that faces the viewer, cut off at its rim. None lies over another.
// error: edges are straight over 2 deg: 1.5e-4 of the radius.
[[nodiscard]] std::vector<Tile> sphere_tiles(const DirectionMap& map, const DecibelRange& range,
                                             const SphereView& view);

// Meridians and parallels on the half that faces the viewer, every so many degrees.
[[nodiscard]] std::vector<std::vector<Point>> graticule(const SphereView& view, double step_deg);

}  // namespace lrcs
