#pragma once
#include <cstdint>
#include <numeric>
#include <vector>

#include "mesh/edges.h"

namespace lrcs {

// Disjoint sets of facets that know whether a facet's winding is opposite to that of its set's root.
class WindingSets {
 public:
  explicit WindingSets(std::size_t facets) : parent_(facets), opposite_(facets, false), torn_(facets, false) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  std::uint32_t root(std::uint32_t facet) {
    // Two passes: find the root, then hang every facet of the path under it with its winding relative to the root.
    std::uint32_t root = facet;
    bool opposite = false;
    for (; parent_[root] != root; root = parent_[root]) opposite = opposite != opposite_[root];
    while (parent_[facet] != root && facet != root) {
      const std::uint32_t next = parent_[facet];
      const bool next_opposite = opposite != opposite_[facet];
      parent_[facet] = root;
      opposite_[facet] = opposite;
      facet = next;
      opposite = next_opposite;
    }
    return root;
  }
  bool is_opposite(std::uint32_t facet) {
    root(facet);
    return opposite_[facet];
  }
  // Says that the windings of two facets are the same or opposite. A contradiction tears the set.
  void join(std::uint32_t a, std::uint32_t b, bool opposite) {
    const std::uint32_t root_a = root(a);
    const std::uint32_t root_b = root(b);
    const bool roots_opposite = (opposite_[a] != opposite_[b]) != opposite;
    if (root_a == root_b) {
      if (roots_opposite) torn_[root_a] = true;
      return;
    }
    parent_[root_b] = root_a;
    opposite_[root_b] = roots_opposite;
    torn_[root_a] = torn_[root_a] || torn_[root_b];
  }
  // Joins facets across edges of two of them, one of which is turned where it must be.
  void join_at_manifold_edges(const Edges& edges) {
    for (std::size_t edge = 0; edge < edges.size(); ++edge) {
      const auto uses = edges.uses(edge);
      if (uses.size() == 2) join(uses[0].facet, uses[1].facet, uses[0].rising == uses[1].rising);
    }
  }
  void tear(std::uint32_t facet) { torn_[root(facet)] = true; }
  [[nodiscard]] bool is_torn(std::uint32_t facet) { return torn_[root(facet)]; }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<bool> opposite_;  // to the parent; false for a root
  std::vector<bool> torn_;      // of a root: not orientable, or what tear() was told of
};

}  // namespace lrcs
