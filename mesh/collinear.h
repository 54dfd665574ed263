#pragma once
#include "base/vec3.h"

namespace lrcs {

// Do three places lie on a line, exactly? The same as facet_cross() (mesh/facet_mesh.h) being zero, sooner.
// domain: as there.
[[nodiscard]] bool are_collinear(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace lrcs
