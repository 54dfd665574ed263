#include "mesh/collinear.h"

#include <cmath>

#include "mesh/facet_mesh.h"

namespace lrcs {

bool are_collinear(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 p = b - a, q = c - a;
  for (int k = 0; k < 3; ++k) {
    const double pq = p[(k + 1) % 3] * q[(k + 2) % 3], qp = p[(k + 2) % 3] * q[(k + 1) % 3];
    // Two differences and a product each, and the difference of the two: four roundings.
    constexpr double four_roundings = 0x1p-51;
    if (std::abs(pq - qp) > four_roundings * (std::abs(pq) + std::abs(qp))) return false;
  }
  return facet_cross(a, b, c).isZero(0.0);
}

}  // namespace lrcs
