#pragma once
#include <array>

#include "base/vec3.h"
#include "lrcs/occluders.h"

namespace lrcs {

// How far the place on the true surface that a place on a flat facet stands for lies from it: over it, and beside it
// where the surface's parameters do not run straight.
// value: of second degree, with the sagittas of its sides; lengths of the occluders.
// error: of third order in the facet's size. domain: occluders of a mesh with curved facets.
struct FacetRise {
  std::array<Vec3, 3> sagittas;  // of the sides from corner k to corner k + 1

  FacetRise(const Occluders& occluders, std::uint32_t facet) : sagittas(occluders.sagittas[facet]) {}

  // By the weights of the second and the third corner.
  [[nodiscard]] Vec3 at(double u, double v) const {
    const double w = 1.0 - u - v;
    return 4.0 * (w * u * sagittas[0] + u * v * sagittas[1] + v * w * sagittas[2]);
  }
};

}  // namespace lrcs
