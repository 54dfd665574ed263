#pragma once
#include <cstddef>
#include <vector>

#include "mesh/repair.h"

namespace lrcs {

// What repair_thoroughly() may do beyond repair().
struct RepairWishes {
  double tolerance = 0.0;           // gaps to close [positions' unit]; 0: only T-junctions exactly on edges
  bool drop_opposite = false;       // of two facets of the same vertices that face opposite ways, drop the later
  std::size_t most_hole_edges = 0;  // fill holes whose rims have at most so many edges; 0: fill none
};

// What repair_thoroughly() did to a part or to the whole.
struct ThoroughCounts : RepairCounts {
  std::size_t near_vertices = 0;  // welded across a gap; of parts 0
  std::size_t t_junctions = 0;    // vertices put into the edges of other facets; of parts 0
  std::size_t opposite = 0;       // dropped
  std::size_t holes_filled = 0;   // of parts 0
  bool complete = true;           // else gaps are left: counting stopped (mesh/gaps.h)
};
struct ThoroughRepairs {
  ThoroughCounts all;
  std::vector<ThoroughCounts> parts;  // in the order of mesh.part.names
};

// repair(), and what may change the surface by the tolerance: gaps are closed (gaps.h), each open piece of a part gets
// one winding, that of most of its facets (windings.h), holes are filled where asked; then shells that are closed now
// face outward.
// domain: no curved patches. laws: with all wishes off, facets that repair() keeps stay, but for T-junctions and open
// pieces of mixed windings; doing it again does nothing.
// check: tests/mesh/thorough_repair_test.cpp
ThoroughRepairs repair_thoroughly(FacetMesh& mesh, const RepairWishes& wishes);

}  // namespace lrcs
