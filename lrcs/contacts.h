#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "lrcs/facet_tree.h"
#include "lrcs/occluder_edges.h"
#include "lrcs/occluders.h"

namespace lrcs {

// Where other facets pass through a facet or touch it along a line or an area: found once, for every direction.
// What only comes near may be among it: it does no harm.
class Contacts {
 public:
  // A vertex, or the place on the edge between two where it passes the facet's plane (FacetFrame::passage()).
  struct Place {
    std::uint32_t low, high;
  };
  // Where a facet passes through the plane of this one: seen from its front, the passing facet's winding goes below the
  // plane at `leaves` and comes up again at `enters`.
  struct Passage {
    std::uint32_t facet;  // that passes
    Place leaves, enters;
  };
  // An edge that lies in the facet's plane.
  struct LyingEdge {
    std::uint32_t edge;
    std::uint32_t first_side;  // of the sides: one for each facet at the edge, in the order of OccluderEdges
  };
  struct Of {  // one facet's
    std::span<const Passage> passages;
    std::span<const LyingEdge> edges;
    std::span<const std::uint32_t> coplanar;  // facets that lie in the plane, on this one or under it
  };

  Contacts(const Occluders& occluders, const FacetTree& tree, const OccluderEdges& edges);

  [[nodiscard]] bool any(std::uint32_t facet) const { return place_[facet] != none; }
  // The facets [first, last) that have contacts.
  [[nodiscard]] std::span<const std::uint32_t> among(std::uint32_t first, std::uint32_t last) const;
  // domain: any(facet).
  [[nodiscard]] Of of(std::uint32_t facet) const;
  // For the facets at a lying edge: does each rise from the plane to the front (+1), to the back (-1) or lie in it (0)?
  [[nodiscard]] const std::int8_t* sides(const LyingEdge& edge) const { return &sides_[edge.first_side]; }
  // Facets that have contacts.
  [[nodiscard]] std::size_t size() const { return begins_.size(); }

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  struct Begin {
    std::uint32_t passages, edges, coplanar;
  };

  std::vector<std::uint32_t> place_;   // of each facet in begins_; none
  std::vector<std::uint32_t> facets_;  // that have contacts, ascending; one for each of begins_
  std::vector<Begin> begins_;
  std::vector<Passage> passages_;
  std::vector<LyingEdge> edges_;
  std::vector<std::uint32_t> coplanar_;
  std::vector<std::int8_t> sides_;
};

}  // namespace lrcs
