#pragma once
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/facet_mesh.h"

namespace lrcs {

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

// Who is next to whom, as a half-edge mesh.
struct HalfEdges {
  HalfEdgeMesh mesh;
  std::vector<std::uint32_t> facet;  // for every face of `mesh`, by its idx(): the facet of the FacetMesh
  std::size_t detached = 0;          // facets that no manifold surface could hold: put in on vertices of their own
};

// The half-edge mesh of a target; vertices of equal position are one vertex.
// laws: facets with two equal corners are left out, every other one is in it once, in order. Where a facet's edge is
// taken already (three facets at an edge, opposite windings) or its vertex would not be manifold, it is detached: it
// gets new vertices, and its edges are boundaries.
[[nodiscard]] HalfEdges half_edges(const FacetMesh& facets);

}  // namespace lrcs
