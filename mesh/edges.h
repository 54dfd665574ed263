#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/facet_mesh.h"

namespace lrcs {

// One facet's use of the edge between two vertices.
struct EdgeUse {
  std::uint32_t low;   // the smaller vertex index
  std::uint32_t high;  // the larger
  std::uint32_t facet;
  bool rising;  // the facet's winding runs from low to high
};

// All edges of some facets of a welded mesh, the uses of one edge side by side, in the order of the facets.
// An edge of one use is a boundary; of two, manifold; of more, not manifold.
// domain: facets of three different vertices.
class Edges {
 public:
  Edges(const FacetMesh& welded, std::span<const std::uint32_t> facets);
  explicit Edges(const FacetMesh& welded);  // of all facets

  [[nodiscard]] std::size_t size() const { return begins_.size() - 1; }
  [[nodiscard]] std::span<const EdgeUse> uses(std::size_t edge) const {
    return std::span(uses_).subspan(begins_[edge], begins_[edge + 1] - begins_[edge]);
  }

 private:
  std::vector<EdgeUse> uses_;
  std::vector<std::size_t> begins_;  // of each edge in uses_, and the end
};

// The edges that only one facet of a mesh uses, by the use. domain: as above.
[[nodiscard]] std::vector<EdgeUse> open_edges(const FacetMesh& welded);

}  // namespace lrcs
