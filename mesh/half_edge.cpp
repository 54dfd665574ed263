#include "mesh/half_edge.h"

#include <algorithm>
#include <array>

#include "mesh/weld.h"

namespace lrcs {
namespace {

using Vertices = std::array<HalfEdgeMesh::VertexHandle, 3>;

// OpenMesh writes to the standard error stream where it refuses a face; a library must not.
class QuietOpenMesh {
 public:
  QuietOpenMesh() : was_enabled_(omerr().is_enabled()) { omerr().disable(); }
  ~QuietOpenMesh() {
    if (was_enabled_) omerr().enable();
  }
  QuietOpenMesh(const QuietOpenMesh&) = delete;
  QuietOpenMesh& operator=(const QuietOpenMesh&) = delete;

 private:
  bool was_enabled_;
};

HalfEdgeMesh::VertexHandle add_vertex(HalfEdgeMesh& mesh, const Vec3& p) {
  return mesh.add_vertex(HalfEdgeMesh::Point(p.x(), p.y(), p.z()));
}

}  // namespace

HalfEdges half_edges(const FacetMesh& facets) {
  const QuietOpenMesh quiet;
  const std::vector<std::uint32_t> first = first_equal(facets.positions);
  HalfEdges result;
  std::vector<HalfEdgeMesh::VertexHandle> vertex(first.size());
  const auto vertex_at = [&](std::uint32_t position) {
    auto& handle = vertex[first[position]];
    if (!handle.is_valid()) handle = add_vertex(result.mesh, facets.positions[position]);
    return handle;
  };
  for (std::uint32_t k = 0; k < facets.size(); ++k) {
    const auto& corners = facets.facets[k];
    Vertices face{vertex_at(corners[0]), vertex_at(corners[1]), vertex_at(corners[2])};
    if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) continue;
    if (!result.mesh.add_face(face.data(), face.size()).is_valid()) {
      for (std::size_t c = 0; c < 3; ++c) face[c] = add_vertex(result.mesh, facets.positions[corners[c]]);
      result.mesh.add_face(face.data(), face.size());
      ++result.detached;
    }
    result.facet.push_back(k);
  }
  return result;
}

}  // namespace lrcs
