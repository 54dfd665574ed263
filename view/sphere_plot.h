#pragma once
#include "base/direction.h"
#include "view/direction_sphere.h"
#include "view/map_plot.h"

namespace lrcs {

// The two spheres of such a plot: from the given direction, and from the opposite one.
struct SpherePair {
  SphereView front, back;
};

// Draws LRCS in dBsm on the sphere of directions, as colours: seen from far away in the direction `from`, and beside it
// from the opposite one, so that every direction is seen once.
// frame: view/direction_sphere.h. Lines every 30 deg; the axes of the body stand out: x forward, y left, z up.
// value, domain: as draw_map_plot. check: tests/view/sphere_plot_test.cpp.
SpherePair draw_sphere_plot(Canvas& canvas, const DirectionMap& map, const AspectAngles& from, const MapText& text);

// The same into a PNG or SVG, 1600 x 1000 pixels.
void draw_sphere_plot(const std::filesystem::path& file, const DirectionMap& map, const AspectAngles& from,
                      const MapText& text);

}  // namespace lrcs
