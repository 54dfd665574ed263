#pragma once
#include "base/vec3.h"
#include "mesh/facet_mesh.h"

namespace lrcs {

// What floats around 1 make of places, when rays and facets are computed from them: 16 of their roundings of 2^-23,
// rounded up.
inline constexpr double float_error = 2e-6;

// Where a target is put for those who know floats only: centred, its largest side 1.
struct Placement {
  explicit Placement(const FacetMesh& mesh);

  [[nodiscard]] Vec3 placed(const Vec3& p) const { return scale * (p - centre); }

  Vec3 centre;         // [m]
  double scale = 1.0;  // [1/m]
};

inline Placement::Placement(const FacetMesh& mesh) {
  Vec3 low = mesh.positions.front(), high = low;
  for (const Vec3& p : mesh.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  centre = 0.5 * (low + high);
  scale = 1.0 / (high - low).maxCoeff();
}

}  // namespace lrcs
