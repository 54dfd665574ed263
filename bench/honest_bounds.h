#pragma once
#include <string>

#include "mesh/facet_mesh.h"

namespace lrcs {

// Do the bounds of accuracy {relative: r} hold? Rows at r = 1e-2 and 1e-3 beside the exact way, Wu's metal-skin-5p (a
// full return even at grazing light), both sides: monostatic, and 40 and 90 deg apart in both planes; directions at
// round angles, as users choose them, and at random ones. value: what to print; rows that pass their bound are named.
[[nodiscard]] std::string honest_bounds_text(const FacetMesh& mesh, bool is_short);

}  // namespace lrcs
