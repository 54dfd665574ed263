#pragma once
#include <cstdint>

#include "lrcs/occluder_edges.h"
#include "lrcs/occluders.h"

namespace lrcs {

// How far an outline of the true surface lies beside an edge of facets that stands for it, as seen along one direction:
// at the ends of a straight line with the same area beside the edge. Across the view, lengths of the occluders.
struct OutlineBend {
  Vec3 at_low = Vec3::Zero(), at_high = Vec3::Zero();
};

// Of an edge at which two facets of curved surfaces meet. A fold of a smooth surface is where the surface turns away
// from the viewer: from the edge, on which the normal n leans by e = n . toward, that lies e^2 / (2 k) further out, k
// the curvature along the view, and the arc over the edge rises by its sagitta. At a crease it is the edge's own arc.
// error: of third order in the facets' size; zero, not a guess, where the surface gives no such fold nearby.
// domain: occluders of a mesh with curved facets; use: two facets. check: tests/lrcs/curved_sections_test.cpp.
[[nodiscard]] OutlineBend outline_bend(const Occluders& occluders, const OccluderEdges::Edge& edge, const Vec3& toward);

}  // namespace lrcs
