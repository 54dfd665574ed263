#pragma once
#include <cstdint>

#include "mesh/facet_mesh.h"

namespace lrcs {

// A convex target: the icosahedron, each facet cut in four `subdivisions` times, vertices on the unit sphere [m].
// shape: 20 4^subdivisions facets, outward.
[[nodiscard]] FacetMesh icosphere(std::uint32_t subdivisions);

}  // namespace lrcs
