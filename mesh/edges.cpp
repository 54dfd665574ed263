#include "mesh/edges.h"

#include <algorithm>
#include <tuple>

#include "base/bucket_sort.h"

namespace lrcs {

Edges::Edges(const FacetMesh& welded, std::span<const std::uint32_t> facets) {
  const auto each_use = [&](const auto& put) {
    for (const std::uint32_t facet : facets) {
      const auto& corners = welded.facets[facet];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = corners[k];
        const std::uint32_t b = corners[(k + 1) % 3];
        put(EdgeUse{std::min(a, b), std::max(a, b), facet, a < b});
      }
    }
  };
  uses_ = bucket_sorted<EdgeUse>(
      each_use, [](const EdgeUse& use) { return use.low; },
      [](const EdgeUse& a, const EdgeUse& b) { return std::tie(a.high, a.facet) < std::tie(b.high, b.facet); });
  begins_.reserve(uses_.size() / 2 + 1);
  for (std::size_t k = 0; k < uses_.size(); ++k) {
    if (k == 0 || uses_[k].low != uses_[k - 1].low || uses_[k].high != uses_[k - 1].high) begins_.push_back(k);
  }
  begins_.push_back(uses_.size());
}

}  // namespace lrcs
