#include "mesh/edges.h"

#include <algorithm>
#include <tuple>

namespace lrcs {

Edges::Edges(const FacetMesh& welded, std::span<const std::uint32_t> facets) {
  uses_.reserve(3 * facets.size());
  for (const std::uint32_t facet : facets) {
    const auto& corners = welded.facets[facet];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = corners[k];
      const std::uint32_t b = corners[(k + 1) % 3];
      uses_.push_back({std::min(a, b), std::max(a, b), facet, a < b});
    }
  }
  std::sort(uses_.begin(), uses_.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::tie(a.low, a.high, a.facet) < std::tie(b.low, b.high, b.facet);
  });
  for (std::size_t k = 0; k < uses_.size(); ++k) {
    if (k == 0 || uses_[k].low != uses_[k - 1].low || uses_[k].high != uses_[k - 1].high) begins_.push_back(k);
  }
  begins_.push_back(uses_.size());
}

}  // namespace lrcs
