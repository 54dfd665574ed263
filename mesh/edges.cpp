#include "mesh/edges.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "base/bucket_sort.h"
#include "base/large_pages.h"

namespace lrcs {
namespace {

std::vector<std::uint32_t> all_facets(const FacetMesh& mesh) {
  std::vector<std::uint32_t> all = large_vector<std::uint32_t>(mesh.size());
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

}  // namespace

Edges::Edges(const FacetMesh& welded) : Edges(welded, all_facets(welded)) {}

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
  reserve_large(begins_, uses_.size() / 2 + 1);
  for (std::size_t k = 0; k < uses_.size(); ++k) {
    if (k == 0 || uses_[k].low != uses_[k - 1].low || uses_[k].high != uses_[k - 1].high) begins_.push_back(k);
  }
  begins_.push_back(uses_.size());
}

std::vector<EdgeUse> open_edges(const FacetMesh& welded) {
  const Edges edges(welded);
  std::vector<EdgeUse> open;
  for (std::size_t edge = 0; edge < edges.size(); ++edge)
    if (edges.uses(edge).size() == 1) open.push_back(edges.uses(edge)[0]);
  return open;
}

}  // namespace lrcs
