#pragma once
#include "base/vec3.h"
#include "mesh/facet_mesh.h"

namespace lrcs {

// What floats around 1 make of places, when rays and facets are computed from them: 16 of their roundings of 2^-23,
// rounded up.
inline constexpr double float_error = 2e-6;

// Where a target is put for those who know floats only: its facets centred, their largest side 1; vertices of no facet
// may lie anywhere.
struct Placement {
  explicit Placement(const FacetMesh& mesh);

  [[nodiscard]] Vec3 placed(const Vec3& p) const { return scale * (p - centre); }

  Vec3 centre = Vec3::Zero();  // [m]
  double scale = 1.0;          // [1/m]
};

inline Placement::Placement(const FacetMesh& mesh) {
  if (mesh.facets.empty()) return;
  Vec3 low = mesh.positions[mesh.facets.front()[0]], high = low;
  for (const auto& facet : mesh.facets)
    for (const std::uint32_t k : facet) {
      low = low.cwiseMin(mesh.positions[k]);
      high = high.cwiseMax(mesh.positions[k]);
    }
  centre = 0.5 * (low + high);
  scale = 1.0 / (high - low).maxCoeff();
}

}  // namespace lrcs
