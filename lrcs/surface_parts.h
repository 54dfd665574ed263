#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "lrcs/occluder_edges.h"
#include "lrcs/occluders.h"

namespace lrcs {

// The parts of a target: pieces of its surface connected across edges, however many facets meet there.
// shape: parts in the order of their first facets. Parts that touch in a vertex only both have it.
class SurfaceParts {
 public:
  SurfaceParts(const Occluders& occluders, const OccluderEdges& edges);
  // The same parts, where only some facets are left: `occluders`. A part may have none. shape: kept: one a facet.
  SurfaceParts(const SurfaceParts& whole, const std::vector<std::uint8_t>& kept, const Occluders& occluders);

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(convex_.size()); }
  [[nodiscard]] std::uint32_t of(std::uint32_t facet) const { return part_[facet]; }
  // Ascending.
  [[nodiscard]] std::span<const std::uint32_t> facets(std::uint32_t part) const {
    return std::span(facets_).subspan(first_facet_[part], first_facet_[part + 1] - first_facet_[part]);
  }
  // Each once, those of one facet after those of another.
  [[nodiscard]] std::span<const std::uint32_t> vertices(std::uint32_t part) const {
    return std::span(vertices_).subspan(first_vertex_[part], first_vertex_[part + 1] - first_vertex_[part]);
  }
  // Is the part a convex body (lrcs/convexity.h), exactly, all of it? Not asked of a target that is one part.
  [[nodiscard]] bool is_convex(std::uint32_t part) const { return convex_[part] != 0; }

 private:
  void number_parts(const OccluderEdges& edges);
  void list_facets();
  void list_vertices(const Occluders& occluders);

  std::vector<std::uint32_t> part_;  // one a facet
  std::vector<std::uint32_t> facets_, first_facet_;
  std::vector<std::uint32_t> vertices_, first_vertex_;
  std::vector<std::uint8_t> convex_;
};

}  // namespace lrcs
