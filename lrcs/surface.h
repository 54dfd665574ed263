#pragma once
#include <cstdint>
#include <vector>

#include "lrcs/contacts.h"
#include "lrcs/facet_tree.h"
#include "lrcs/hull_facets.h"
#include "lrcs/occluder_edges.h"
#include "lrcs/occluders.h"
#include "lrcs/surface_parts.h"

namespace lrcs {

// All that is known of a target's facets whatever the direction, built once and shared by threads.
struct Surface {
  Occluders occluders;
  FacetTree tree;
  OccluderEdges edges;
  Contacts contacts;
  std::vector<std::uint8_t> of_solid;  // one a facet: see solid_facets() (lrcs/solids.h)
  SurfaceParts parts;
  HullFacets hull;
  // The occluders' positions relative to their centre, an array for each axis.
  std::vector<double> x, y, z;

  explicit Surface(const FacetMesh& mesh);
  // What is left of it where only some facets count (lrcs/never_faced.h): parts and hulls are those of the whole.
  // shape: kept: one a facet.
  Surface(const Surface& whole, const std::vector<std::uint8_t>& kept);

 private:
  void list_positions();
};

}  // namespace lrcs
