#pragma once
#include "mesh/facet_mesh.h"

namespace lrcs::bench {

// A closed sphere of waves, r = 1 + 0.1 [sin 7p sin^2 t cos 9t + 0.5 sin(23p + 1) sin^3 t sin 31t] (p azimuth, t polar
// angle), with many silhouettes before each other. shape: 4 rings (rings - 1) facets, measured.
[[nodiscard]] FacetMesh bumpy_sphere(unsigned rings);

}  // namespace lrcs::bench
