#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.h"

namespace lrcs {

// Cuts a polygon into triangles without adding vertices, and appends them to `facets`.
// value: where the polygon is convex, the fan from its first corner: (0, 1, 2), (0, 2, 3), ... (a corner of 180
// degrees, to 2^-16 rad, is convex, and may make a facet of area zero that keeps its neighbours connected). Where it is
// not, the constrained Delaunay triangulation of its inside. Judged as projected along the coordinate axis nearest to
// its normal; the winding is kept. domain: at least 3 corners, indices into positions. A polygon that has no inside (it
// crosses itself, or all its corners lie on a line) is cut as a fan. check: area and number of triangles of combs,
// stars and bridged holes (tests/mesh/polygon_cut_test.cpp).
void cut_polygon(const std::vector<Vec3>& positions, std::span<const std::uint32_t> corners,
                 std::vector<std::array<std::uint32_t, 3>>& facets);

}  // namespace lrcs
