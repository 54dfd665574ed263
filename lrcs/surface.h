#pragma once
#include <cstdint>
#include <vector>

#include "lrcs/contacts.h"
#include "lrcs/facet_tree.h"
#include "lrcs/occluder_edges.h"
#include "lrcs/occluders.h"

namespace lrcs {

// All that is known of a target's facets whatever the direction, built once and shared by threads.
struct Surface {
  Occluders occluders;
  FacetTree tree;
  OccluderEdges edges;
  Contacts contacts;
  std::vector<std::uint8_t> of_solid;  // one a facet: see solid_facets()
  // The occluders' positions relative to their centre, an array for each axis.
  std::vector<double> x, y, z;

  explicit Surface(const FacetMesh& mesh);
};

// The facets of which only the front can be seen, and which block only where their front is seen as far as others are
// concerned: 1, those of solids. A solid is a connected piece of the surface whose every edge has two of its facets, of
// one winding, in contact with no facet of its own, that encloses a positive volume beyond rounding.
// Why it is enough to count their fronts: from a place outside of the solid, or on its outside, a line to the viewer
// leaves it as often as it enters it. Backs of a solid's facets are hidden by the solid itself.
[[nodiscard]] std::vector<std::uint8_t> solid_facets(const Occluders& occluders, const OccluderEdges& edges,
                                                     const Contacts& contacts);

}  // namespace lrcs
