#pragma once
#include <array>
#include <vector>

#include "mesh/facet_mesh.h"

namespace lrcs {

// Normals at the corners of every facet, unit, on the front side.
// shape: one entry a facet.
using CornerNormals = std::vector<std::array<Vec3, 3>>;

// Estimated from the facets round each vertex. Facets that share an edge are one surface there if their normals are at
// most `crease_angle` [rad] apart; a facet's normal at a corner is the mean of those of the one surface that it belongs
// to round that vertex, weighted so that it is exact where its vertices lie on a sphere, or on a cylinder in
// rectangles. An edge of one facet, of more than two, or of opposite windings is a crease. domain: a welded mesh, or
// every facet is by itself. A facet of area zero counts for nothing. cost: O(N log N). source: N. Max, Weights for
// computing vertex normals from facet normals, J. Graphics Tools 4(2), 1-6, 1999. check:
// tests/mesh/corner_normals_test.cpp
[[nodiscard]] CornerNormals estimated_normals(const FacetMesh& welded, double crease_angle);

}  // namespace lrcs
