#include "mesh/corner_normals.h"

#include <algorithm>
#include <cmath>

#include "mesh/disjoint_sets.h"
#include "mesh/edges.h"

namespace lrcs {
namespace {

// Corner k of facet f is number 3 f + k.
std::uint32_t corner_at(const FacetMesh& mesh, std::uint32_t facet, std::uint32_t vertex) {
  const auto& corners = mesh.facets[facet];
  const auto k = std::find(corners.begin(), corners.end(), vertex) - corners.begin();
  return 3 * facet + static_cast<std::uint32_t>(k);
}

DisjointSets smooth_corners(const FacetMesh& mesh, double crease_angle) {
  const Edges edges(mesh);
  DisjointSets corners(3 * mesh.size());
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    const auto uses = edges.uses(edge);
    if (uses.size() != 2 || uses[0].rising == uses[1].rising) continue;
    const Vec3 &m = mesh.normals[uses[0].facet], &n = mesh.normals[uses[1].facet];
    if (std::atan2(m.cross(n).norm(), m.dot(n)) > crease_angle) continue;
    for (const std::uint32_t vertex : {uses[0].low, uses[0].high})
      corners.join(corner_at(mesh, uses[0].facet, vertex), corner_at(mesh, uses[1].facet, vertex));
  }
  return corners;
}

}  // namespace

CornerNormals estimated_normals(const FacetMesh& welded, double crease_angle) {
  DisjointSets sets = smooth_corners(welded, crease_angle);
  std::vector<Vec3> sums(3 * welded.size(), Vec3::Zero());
  for (std::uint32_t f = 0; f < welded.size(); ++f) {
    if (welded.areas[f] == 0.0) continue;
    const auto corners = welded.corners(f);
    for (std::uint32_t k = 0; k < 3; ++k) {
      // Max's weight, the sine of the angle over both sides' lengths, on the normal: the cross product over the
      // squares.
      const Vec3 to_next = corners[(k + 1) % 3] - corners[k], to_last = corners[(k + 2) % 3] - corners[k];
      const double weight = 2.0 * welded.areas[f] / (to_next.squaredNorm() * to_last.squaredNorm());
      sums[sets.root(3 * f + k)] += weight * welded.normals[f];
    }
  }
  CornerNormals normals(welded.size());
  for (std::uint32_t f = 0; f < welded.size(); ++f)
    for (std::uint32_t k = 0; k < 3; ++k) normals[f][k] = sums[sets.root(3 * f + k)].stableNormalized();
  return normals;
}

}  // namespace lrcs
