#pragma once
#include <numbers>
#include <variant>

#include "lrcs/cross_section.h"

namespace lrcs {

using Extended = Eigen::Matrix<long double, 3, 1>;

// The same sum in extended precision for a convex target: every facet that both sides face is seen whole.
inline long double convex_sigma(const Target& target, const Vec3& di, const Vec3& dr) {
  const Extended wi = di.cast<long double>(), wr = dr.cast<long double>();
  long double sum = 0.0L;
  for (std::size_t k = 0; k < target.mesh.size(); ++k) {
    const auto [a, b, c] = target.mesh.corners(k);
    const Extended p = a.cast<long double>(), u = b.cast<long double>() - p, v = c.cast<long double>() - p;
    const Extended cross = u.cross(v);
    const long double length = cross.norm();
    if (length == 0.0L) continue;
    const Extended n = cross / length;
    if (n.dot(wi) <= 0.0L || n.dot(wr) <= 0.0L) continue;
    sum += 0.5L * length *
           std::visit([&](const auto& model) { return static_cast<long double>(model.f_cos_cos(wi, wr, n)); },
                      target.materials[target.material[k]].brdf);
  }
  return 4.0L * std::numbers::pi_v<long double> * sum;
}

}  // namespace lrcs
