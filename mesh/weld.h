#pragma once
#include <cstdint>
#include <vector>

#include "base/vec3.h"

namespace lrcs {

// For every position the index of the first one that is exactly equal to it (0.0 and -0.0 are equal).
// shape: positions: N, out: N. cost: O(N).
[[nodiscard]] std::vector<std::uint32_t> first_equal(const std::vector<Vec3>& positions);

// Keeps the first of equal positions, in their order, and tells for every one the place of the one kept.
// shape: positions: N, after that the different ones; out: N.
std::vector<std::uint32_t> keep_different(std::vector<Vec3>& positions);

}  // namespace lrcs
