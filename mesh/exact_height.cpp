#include "mesh/exact_height.h"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>

#include "base/expansion.h"

namespace lrcs {
namespace {

using Difference = std::array<Unrounded, 3>;

Difference difference(const Vec3& a, const Vec3& b) {
  return {sum_of(a.x(), -b.x()), sum_of(a.y(), -b.y()), sum_of(a.z(), -b.z())};
}

// w (u1 v2 - u2 v1), added to `sum`.
void add_term(Expansion<192>& sum, const Unrounded& w, const Unrounded& u1, const Unrounded& v2, const Unrounded& u2,
              const Unrounded& v1) {
  Expansion<16> minor;
  for (const double a : {u1.value, u1.error})
    for (const double b : {v2.value, v2.error}) minor.add_product(a, b);
  for (const double a : {u2.value, u2.error})
    for (const double b : {v1.value, v1.error}) minor.add_product(-a, b);
  for (std::size_t k = 0; k < minor.size(); ++k) {
    if (w.error != 0.0) sum.add_product(minor[k], w.error);
    sum.add_product(minor[k], w.value);
  }
}

// Smaller coordinates have last bits whose triple products would vanish in double precision.
constexpr double smallest_coordinate = 0x1p-250;

bool are_small(const Vec3& p) {
  return std::any_of(p.begin(), p.end(), [](double x) { return x != 0.0 && std::abs(x) < smallest_coordinate; });
}

double height_by_rationals(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  using Exact = CGAL::Exact_rational;
  const Exact ax(a.x()), ay(a.y()), az(a.z());
  const Exact ux = b.x() - ax, uy = b.y() - ay, uz = b.z() - az;
  const Exact vx = c.x() - ax, vy = c.y() - ay, vz = c.z() - az;
  const Exact wx = p.x() - ax, wy = p.y() - ay, wz = p.z() - az;
  const Exact height = wx * (uy * vz - uz * vy) + wy * (uz * vx - ux * vz) + wz * (ux * vy - uy * vx);
  return CGAL::to_double(height);
}

}  // namespace

double exact_height(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  if (are_small(a) || are_small(b) || are_small(c) || are_small(p)) return height_by_rationals(a, b, c, p);
  const Difference u = difference(b, a), v = difference(c, a), w = difference(p, a);
  Expansion<192> height;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3, last = (k + 2) % 3;
    add_term(height, w[k], u[next], v[last], u[last], v[next]);
  }
  return height.rounded();
}

}  // namespace lrcs
