#include "mesh/facet_mesh.h"

#include <cmath>

namespace lrcs {
namespace {

// The real number value + error; value is it rounded.
struct Unrounded {
  double value;
  double error;
};

Unrounded sum_of(double a, double b) {
  const double value = a + b;
  const double b_part = value - a;
  return {value, (a - (value - b_part)) + (b - b_part)};
}

Unrounded product_of(double a, double b) {
  const double value = a * b;
  return {value, std::fma(a, b, -value)};
}

// The sum of the products, right to one unit in the last place, zero only if it is zero.
double exact_sum(const std::array<Unrounded, 8>& products) {
  std::array<double, 16> parts{};  // do not overlap, smallest first
  std::size_t size = 0;
  const auto add = [&](double term) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < size; ++k) {
      const Unrounded sum = sum_of(term, parts[k]);
      if (sum.error != 0.0) parts[kept++] = sum.error;
      term = sum.value;
    }
    if (term != 0.0) parts[kept++] = term;
    size = kept;
  };
  for (const Unrounded& product : products) {
    add(product.error);
    add(product.value);
  }
  double total = 0.0;
  for (std::size_t k = 0; k < size; ++k) total += parts[k];
  return total;
}

// p q - r s.
double difference_of_products(Unrounded p, Unrounded q, Unrounded r, Unrounded s) {
  const Unrounded pq = product_of(p.value, q.value);
  const Unrounded rs = product_of(r.value, s.value);
  const Unrounded leading = sum_of(pq.value, -rs.value);
  const double cross_terms = (p.value * q.error + p.error * q.value) - (r.value * s.error + r.error * s.value);
  const double quick = leading.value + (leading.error + ((pq.error - rs.error) + cross_terms));
  // The quick value is off by less than 2^-100 of the products; that is below half a unit of what cancelled less than
  // this.
  constexpr double worst_cancellation = 0x1p-46;
  if (std::abs(quick) >= worst_cancellation * (std::abs(pq.value) + std::abs(rs.value))) return quick;
  return exact_sum({pq, product_of(p.value, q.error), product_of(p.error, q.value), product_of(p.error, q.error),
                    product_of(-r.value, s.value), product_of(-r.value, s.error), product_of(-r.error, s.value),
                    product_of(-r.error, s.error)});
}

}  // namespace

Vec3 facet_cross(const Vec3& a, const Vec3& b, const Vec3& c) {
  std::array<Unrounded, 3> p{};
  std::array<Unrounded, 3> q{};
  for (int k = 0; k < 3; ++k) {
    p[static_cast<std::size_t>(k)] = sum_of(b[k], -a[k]);
    q[static_cast<std::size_t>(k)] = sum_of(c[k], -a[k]);
  }
  return {difference_of_products(p[1], q[2], p[2], q[1]), difference_of_products(p[2], q[0], p[0], q[2]),
          difference_of_products(p[0], q[1], p[1], q[0])};
}

void measure_facets(FacetMesh& mesh) {
  mesh.normals.resize(mesh.size());
  mesh.areas.resize(mesh.size());
  for (std::size_t k = 0; k < mesh.size(); ++k) {
    const auto [a, b, c] = mesh.corners(k);
    const Vec3 cross = facet_cross(a, b, c);
    const double length = cross.stableNorm();
    mesh.areas[k] = 0.5 * length * mesh.metres_per_unit * mesh.metres_per_unit;
    mesh.normals[k] = length > 0.0 ? Vec3(cross / length) : Vec3::Zero();
  }
}

}  // namespace lrcs
