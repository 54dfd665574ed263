#include "lrcs/exact_height.h"

#include <CGAL/Exact_rational.h>

namespace lrcs {

double exact_height(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  using Exact = CGAL::Exact_rational;
  const Exact ax(a.x()), ay(a.y()), az(a.z());
  const Exact ux = b.x() - ax, uy = b.y() - ay, uz = b.z() - az;
  const Exact vx = c.x() - ax, vy = c.y() - ay, vz = c.z() - az;
  const Exact wx = p.x() - ax, wy = p.y() - ay, wz = p.z() - az;
  const Exact height = wx * (uy * vz - uz * vy) + wy * (uz * vx - ux * vz) + wz * (ux * vy - uy * vx);
  return CGAL::to_double(height);
}

}  // namespace lrcs
