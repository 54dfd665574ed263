#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "lrcs/cross_section.h"
#include "lrcs/sweep_plan.h"

namespace lrcs {

// Two facets that lie in one plane, one on the other, as numbers of the mesh: which of them counts hangs on their
// order.
using CoincidentFacets = std::array<std::uint32_t, 2>;

// Which planes normal to the axes sought mirror the target onto itself: every facet has its image, of the same
// materials, the front being the image of the front, and coincident facets of different materials come in the same
// order. Verified, not assumed: a vertex and its image lie to either side of the plane at the same distance, exactly,
// whether their coordinates' sum is a double or not. Facets of area zero do not count. law: sigma and seen area of the
// given facets are the same for two directions and for their images.
[[nodiscard]] MirrorPlanes mirror_planes(const Target& target, const MirrorPlanes& sought,
                                         const std::vector<CoincidentFacets>& coincident);

}  // namespace lrcs
