#include "lrcs/occluder_edges.h"

#include <algorithm>

#include "base/bucket_sort.h"
#include "base/large_pages.h"

namespace lrcs {
namespace {

struct Side {               // of a facet
  std::uint32_t low, high;  // vertices
  std::uint32_t facet;
  std::uint32_t corner;
};

std::vector<Side> sorted_sides(const Occluders& occluders) {
  const auto each_side = [&](const auto& put) {
    for (std::uint32_t f = 0; f < occluders.size(); ++f)
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t a = occluders.facets[f][k], b = occluders.facets[f][(k + 1) % 3];
        put(Side{std::min(a, b), std::max(a, b), f, k});
      }
  };
  return bucket_sorted<Side>(
      each_side, [](const Side& side) { return side.low; },
      [](const Side& a, const Side& b) { return a.high != b.high ? a.high < b.high : a.facet < b.facet; });
}

}  // namespace

OccluderEdges::OccluderEdges(const Occluders& occluders)
    : edge_of_(large_vector<std::array<std::uint32_t, 3>>(occluders.size())) {
  reserve_large(across_, occluders.size());
  across_.assign(occluders.size(), {alone, alone, alone});
  const auto sides = sorted_sides(occluders);
  const auto none = static_cast<std::uint32_t>(2 * occluders.size());
  reserve_large(uses_, sides.size());
  reserve_large(edges_, sides.size() / 2);
  reserve_large(begins_, sides.size() / 2 + 1);
  for (std::size_t k = 0; k < sides.size();) {
    const std::uint32_t low = sides[k].low, high = sides[k].high;
    const auto edge = static_cast<std::uint32_t>(edges_.size());
    edges_.push_back({low, high, {none, none}});
    begins_.push_back(static_cast<std::uint32_t>(uses_.size()));
    for (; k < sides.size() && sides[k].low == low && sides[k].high == high; ++k) {
      const Side& side = sides[k];
      uses_.push_back({side.facet, occluders.facets[side.facet][side.corner] == edges_.back().low});
      edge_of_[side.facet][side.corner] = edge;
    }
    const std::span<const FacetAtEdge> here = std::span(uses_).subspan(begins_.back());
    if (here.size() == 2)
      for (std::size_t u = 0; u < 2; ++u) {
        const Side& side = sides[k - 2 + u];
        across_[side.facet][side.corner] = 2 * here[1 - u].facet + (here[0].rising == here[1].rising ? 1 : 0);
      }
    if (here.size() > 2) crowded_.push_back(edge);
    for (std::size_t u = 0; here.size() <= 2 && u < here.size(); ++u)
      edges_.back().use[u] = 2 * here[u].facet + (here[u].rising ? 1 : 0);
  }
  begins_.push_back(static_cast<std::uint32_t>(uses_.size()));
  edges_.shrink_to_fit();
}

}  // namespace lrcs
