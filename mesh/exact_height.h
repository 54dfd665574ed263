#pragma once
#include "base/vec3.h"

namespace lrcs {

// Six times the signed volume of the tetrahedron (a, b, c, p): (p - a) . [(b - a) x (c - a)], positive in front of (a,
// b, c). Evaluated exactly (base/expansion.h) and rounded at the end: the sign is exact, 0 where and only where the
// four are coplanar. error: one unit in the last place. domain: finite coordinates of size 2^300 at most. cost: below a
// microsecond, five where a coordinate is below 2^-250; for what double precision cannot decide.
[[nodiscard]] double exact_height(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p);

}  // namespace lrcs
