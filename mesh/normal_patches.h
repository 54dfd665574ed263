#pragma once
#include "mesh/corner_normals.h"
#include "mesh/facet_mesh.h"

namespace lrcs {

// Makes every facet stand for a curved patch through its corners that has the given normals there: a cubic Bezier
// triangle (PN triangle), whose sides are drawn as round as arcs. A model of the surface that the facets were made of.
// value: mesh.curved; facets whose three normals are their own stay flat, as do those with a corner whose normal is
// more
//   than `most_turned` off theirs: that surface is not known.
// value returned: those that stayed flat for that, ascending.
// error: over facets of h across of a smooth surface with its true normals, areas and normals are right to O(h^4) in
//   their integrals (measured on spheres and ellipsoids: 20,480 facets 3e-8 and 6e-7; flat facets 4e-4).
// source: A. Vlachos et al., Curved PN triangles, Proc. Interactive 3D Graphics, 159-166, 2001; sides as arcs: control
//   points at 2 / (3 (1 + cos phi)) of the chord, phi between tangent and chord, instead of at cos phi / 3.
// check: tests/mesh/normal_patches_test.cpp
std::vector<std::uint32_t> curve_by_normals(FacetMesh& mesh, const CornerNormals& normals);

// [rad]
constexpr double most_turned = 1.0471975511965976;  // 60 deg

}  // namespace lrcs
