#pragma once
#include <cstdint>
#include <vector>

#include "mesh/edges.h"
#include "mesh/facet_mesh.h"

namespace lrcs {

// A connected, closed, orientable piece of a surface.
struct ClosedShell {
  std::vector<std::uint32_t> facets;    // ascending
  std::vector<std::uint32_t> reversed;  // those of them whose winding must be reversed for the shell to face outward
  double volume = 0.0;                  // enclosed [cube of the positions' unit]; negative for a cavity
  bool in_one_part = false;             // closed without facets of another part
};

// The closed shells of a welded mesh. Facets are connected across edges that two facets use; a shell is closed where
// the windings, once consistent, cancel at every one of its edges. Shells are sought inside each part first, so that
// parts which touch stay apart, then among what is left, across parts. Bodies of one part that lie face to face have
// edges of four facets: facets connected across any edge, whose windings cancel at all of them as given, are one shell.
// Outward: the volume is positive. A shell that lies inside another one is either a cavity or a body of its own: it
// keeps the side that most of its facets face as given (enclosure.h). A shell of no volume (a sheet and its back) keeps
// its windings too. domain: facets of three different vertices, no two the same (repair_connectivity() sees to that).
// error: volume: below 16 eps Sum |a| |b| |c| over the facets, their corners seen from the shell's first one.
[[nodiscard]] std::vector<ClosedShell> closed_shells(const FacetMesh& welded);
// The same for whoever has the edges of all facets already.
[[nodiscard]] std::vector<ClosedShell> closed_shells(const FacetMesh& welded, const Edges& edges);

}  // namespace lrcs
