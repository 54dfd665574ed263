#pragma once
#include <array>

#include "base/vec3.h"
#include "lrcs/occluders.h"

namespace lrcs {

// How far the true surface rises over a flat facet that stands for it, along the facet's normal.
// value: of second degree, with the sagittas that the normals at its corners give its sides; lengths of the occluders.
// error: of third order in the facet's size. domain: occluders of a mesh with curved facets.
struct FacetRise {
  Vec3 normal;                     // unit
  std::array<double, 3> sagittas;  // of the sides from corner k to corner k + 1

  FacetRise(const Occluders& occluders, std::uint32_t facet) : normal(occluders.cross[facet].stableNormalized()) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const Vec3 side =
          occluders.positions[occluders.facets[facet][next]] - occluders.positions[occluders.facets[facet][k]];
      const auto& normals = occluders.corner_normals[facet];
      sagittas[k] = (normals[next] - normals[k]).dot(side) / 8.0;
    }
  }

  [[nodiscard]] double at(double u, double v) const {
    const double w = 1.0 - u - v;
    return 4.0 * (w * u * sagittas[0] + u * v * sagittas[1] + v * w * sagittas[2]);
  }
};

}  // namespace lrcs
