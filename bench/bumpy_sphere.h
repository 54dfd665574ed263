#pragma once
#include <cstdint>

#include "mesh/facet_mesh.h"

namespace lrcs {

// A closed, dense surface that hides parts of itself.
// value: r = 1 + h [sin 7p sin^2 t cos 9t + 0.5 sin(23p + 1) sin^3 t sin 31t], p azimuth, t polar angle, h = 0.1 [m].
// shape: 4 rings (rings - 1) facets, outward. domain: rings >= 2.
[[nodiscard]] FacetMesh bumpy_sphere(std::uint32_t rings);

}  // namespace lrcs
