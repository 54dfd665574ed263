#pragma once
#include <cstdint>
#include <span>

#include "lrcs/occluder_edges.h"
#include "lrcs/occluders.h"
#include "mesh/facet_mesh.h"

namespace lrcs {

// Is the mesh the whole surface of one convex body, its fronts outward? Then a viewer sees every facet that faces it,
// whole, and no visibility need be sought.
// Verified, not assumed: each edge has two facets that run against each other along it, neither with a vertex before
// the other's plane; the mean of the facets' corners is behind every facet; and a line of sight from there passes one
// facet (so that the surface goes round it once). All sides of planes are decided exactly. Facets may be coplanar;
// those of area zero are left out. On a curved surface that is smooth at an edge its facets may bend forward there, as
// they do along seams, if the surface does not: its normals turn apart across the edge, and it rises over it as far as
// they bend. What a viewer sees of the body is told for the surface, then. law: true is certain, but for that; false
// may be said of a body so thin that its middle cannot be told from its surface. cost: a non-convex target is mostly
// known by a few facets. source: K. Mehlhorn et al., Computational Geometry 12, 85-103, 1999 (checking convexity by
// local tests and one ray).
[[nodiscard]] bool is_convex_body(const FacetMesh& mesh);

// The same of some facets of a target: all that stand at their edges. cost: one look at each of them.
[[nodiscard]] bool is_convex_body(const Occluders& occluders, const OccluderEdges& edges,
                                  std::span<const std::uint32_t> facets);

}  // namespace lrcs
