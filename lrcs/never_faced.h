#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "lrcs/surface.h"

namespace lrcs {

// The facets that may count for one of the viewers at least: 1, others 0. shape: one a facet. viewers: unit vectors
// toward them. Others are those of solids whose backs all viewers see, for certain: they are no layers (lrcs/solids.h)
// and nobody sees them, so that without them each viewer sees the same.
[[nodiscard]] std::vector<std::uint8_t> facets_ever_faced(const Surface& surface, std::span<const Vec3> viewers);

}  // namespace lrcs
