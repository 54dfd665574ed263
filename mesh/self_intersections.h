#pragma once
#include <cstddef>

#include "mesh/facet_mesh.h"

namespace lrcs {

// The number of pairs of facets that have a point in common other than the vertices and the edge that they share.
// Exact. Facets that share an edge count where they lie on each other; with the same three vertices (a sheet and its
// back) they do not count. Facets that touch without sharing vertices (a corner on another facet's edge, two bodies
// that lie face to face) do count.
// domain: a welded mesh without facets of area zero (repair.h).
// check: against all pairs, and on bodies put into each other (tests/mesh/self_intersections_test.cpp).
[[nodiscard]] std::size_t self_intersections(const FacetMesh& welded);

}  // namespace lrcs
