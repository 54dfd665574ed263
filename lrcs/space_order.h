#pragma once
#include <cstdint>
#include <vector>

#include "base/vec3.h"

namespace lrcs {

// An order in which points that lie together stand together: halves by number along the longest side of what is left,
// again and again, down to `space_leaf` points. value: a permutation of the indices of `points`.
// law: each run of a leaf, of two leaves, of four ... that FacetTree makes is compact.
[[nodiscard]] std::vector<std::uint32_t> space_order(const std::vector<Vec3>& points);

inline constexpr std::uint32_t space_leaf = 8;

// Where a run of facets is parted in two: the same for the order and for the tree over it.
[[nodiscard]] constexpr std::uint32_t middle_of(std::uint32_t first, std::uint32_t last) {
  return first + (last - first) / 2;
}

}  // namespace lrcs
