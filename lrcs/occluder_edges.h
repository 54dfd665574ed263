#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lrcs/occluders.h"

namespace lrcs {

// A facet at an edge, and on which side of it: with `rising`, the facet's winding runs from the edge's lower vertex to
// its higher one, so that the facet lies left of it where its front is seen.
struct FacetAtEdge {
  std::uint32_t facet;
  bool rising;
};

// The edges of a target and the facets at each, built once.
// shape: edges in the order of their lower vertex, then the higher one.
class OccluderEdges {
 public:
  explicit OccluderEdges(const Occluders& occluders);

  struct Edge {
    std::uint32_t low, high;           // vertices, low < high
    std::array<std::uint32_t, 2> use;  // of one or two facets: 2 facet + (rising ? 1 : 0); else 2 size(): no facet
  };
  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }
  // The facets at an edge, however many.
  [[nodiscard]] std::span<const FacetAtEdge> facets_at(std::uint32_t edge) const {
    return std::span(uses_).subspan(begins_[edge], begins_[edge + 1] - begins_[edge]);
  }
  // Edges of three facets and more; `use` of these is no facet.
  [[nodiscard]] const std::vector<std::uint32_t>& crowded() const { return crowded_; }
  // The edge from a facet's corner k to corner k + 1.
  [[nodiscard]] std::uint32_t edge_of(std::uint32_t facet, std::size_t k) const { return edge_of_[facet][k]; }
  // The facet across that side, if it is the only other one there: 2 facet + (their windings run against each other
  // along it ? 0 : 1), as those of a surface with one outside do; else `alone`.
  static constexpr std::uint32_t alone = 0xffffffff;
  [[nodiscard]] const std::array<std::uint32_t, 3>& across(std::uint32_t facet) const { return across_[facet]; }

 private:
  std::vector<Edge> edges_;
  std::vector<FacetAtEdge> uses_;
  std::vector<std::uint32_t> begins_;
  std::vector<std::uint32_t> crowded_;
  std::vector<std::array<std::uint32_t, 3>> edge_of_, across_;
};

}  // namespace lrcs
