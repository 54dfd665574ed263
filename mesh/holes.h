#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/facet_mesh.h"

namespace lrcs {

// A rim: open edges (of one facet) in a row. Also the outline of a sheet is one: who sees a rim cannot tell.
struct Hole {
  std::vector<std::uint32_t> rim;  // vertices, in the order that a facet in the hole would use them
  std::uint32_t facet = 0;         // one at the rim
  bool is_loop = false;            // the rim ends where it began
};

// The rims of a mesh. One that meets itself is several. Parts that share an edge have none there.
// laws: every open edge is in exactly one of them; all are loops where every edge has one or two facets.
// domain: a welded mesh, facets of three different vertices. check: tests/mesh/holes_test.cpp
[[nodiscard]] std::vector<Hole> holes(const FacetMesh& welded);

// Fills the holes whose rims are loops of at most `most_edges` edges, with the least area (CGAL: Liepa's
// triangulation); a filling is told what the file says of a facet at its rim. The new facets come last.
// value: holes filled. domain: as holes(). The mesh is measured afterwards.
// source: P. Liepa, Filling holes in meshes, Symposium on Geometry Processing, 200-205, 2003.
std::size_t fill_holes(FacetMesh& welded, std::size_t most_edges);

}  // namespace lrcs
