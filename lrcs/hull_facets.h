#pragma once
#include <cstdint>
#include <vector>

#include "lrcs/contacts.h"
#include "lrcs/occluder_edges.h"
#include "lrcs/occluders.h"
#include "lrcs/surface_parts.h"

namespace lrcs {

// Facets on the convex hull of the target, or of their own part of it: no vertex of it is in front of such a facet's
// plane, so nothing of it can stand before the facet, whatever the direction that its outer side faces.
// laws: exact: what is said to be on a hull is. Facets that touch others are left out, for those may lie on them; so
// are some that it would take long to tell of (a plane full of vertices that lie in it but for rounding; hulls that
// millions of facets are on). Backs of solids are not asked for. check: tests/lrcs/hull_facets_test.cpp: against every
// vertex of small targets.
class HullFacets {
 public:
  HullFacets(const Occluders& occluders, const OccluderEdges& edges, const Contacts& contacts,
             const std::vector<std::uint8_t>& of_solid, const SurfaceParts& parts);
  // The same of the facets that are kept. What is not a layer for anyone may be left out: of what is left, nothing
  // comes before a facet that did not before.
  HullFacets(const HullFacets& whole, const std::vector<std::uint8_t>& kept);

  // facing: +1 front, -1 back.
  [[nodiscard]] bool nothing_before(std::uint32_t facet, int facing) const {
    return (sides_[facet] & (facing > 0 ? front : back)) != 0;
  }
  [[nodiscard]] bool nothing_of_its_part_before(std::uint32_t facet, int facing) const {
    return (sides_[facet] & (facing > 0 ? front_in_part : back_in_part)) != 0;
  }
  // On the hull of its part, but not on the target's, with one side at least?
  [[nodiscard]] bool is_on_hull_of_its_part_only(std::uint32_t facet) const {
    const int of_part = sides_[facet] / front_in_part;
    return (of_part & ~sides_[facet] & (front | back)) != 0;
  }
  // Facets on the target's hull.
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  void count();

  enum Side : std::uint8_t { front = 1, back = 2, front_in_part = 4, back_in_part = 8 };

  std::vector<std::uint8_t> sides_;  // one a facet
  std::size_t size_ = 0;
};

}  // namespace lrcs
