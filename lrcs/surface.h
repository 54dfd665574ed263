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
  std::vector<std::uint8_t> of_solid;  // one a facet: see solid_facets() (lrcs/solids.h)
  // The occluders' positions relative to their centre, an array for each axis.
  std::vector<double> x, y, z;

  explicit Surface(const FacetMesh& mesh);
};

}  // namespace lrcs
