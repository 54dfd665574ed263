#pragma once
#include "mesh/facet_mesh.h"

namespace lrcs {

// A made satellite as CAD programs mesh one: solids that touch or pass through each other, large flat panels of two
// facets, cylinders and caps of long thin facets, a truss of bars, a stack of fins.
// frame: x forward, y left, z up [m]; wings along y. shape: closed solids, each facing outward.
[[nodiscard]] FacetMesh spacecraft();

}  // namespace lrcs
