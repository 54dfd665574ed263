#pragma once
#include <cstdint>
#include <vector>

#include "lrcs/contacts.h"
#include "lrcs/facet_tree.h"
#include "lrcs/occluder_edges.h"
#include "lrcs/occluders.h"

namespace lrcs {

// The facets of solids: 1, others 0. shape: one a facet.
// A solid is a piece of the surface, connected across edges, whose windings cancel at every edge, that neither passes
// through itself nor touches itself but in edges and vertices of all that meet there, and around which the surface
// winds nowhere less than zero times: no facet has a place before its front where it does. law: of a solid only fronts
// can be seen, and it is enough to count the fronts that stand before a place outside of it, on it or inside of it:
// from there a line to the viewer leaves the solid at least as often as it enters it. Another solid may pass through it
// or touch it. check: tests/lrcs/solids_test.cpp.
[[nodiscard]] std::vector<std::uint8_t> solid_facets(const Occluders& occluders, const FacetTree& tree,
                                                     const OccluderEdges& edges, const Contacts& contacts);

}  // namespace lrcs
