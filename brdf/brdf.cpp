#include "brdf/brdf.h"

#include "brdf/direction_at.h"

namespace lrcs {

double f_r(const Brdf& brdf, const Vec3& wi, const Vec3& wr, const Vec3& n) {
  const double cos_i = wi.dot(n);
  const double cos_r = wr.dot(n);
  if (!is_above(cos_i) || !is_above(cos_r)) return 0.0;
  const double f_cos_cos = std::visit([&](const auto& model) { return model.f_cos_cos(wi, wr, n); }, brdf);
  return f_cos_cos / cos_i / cos_r;
}

double f_r_angles(const Brdf& brdf, double theta_i, double theta_r, double phi) {
  const Vec3 wi = direction_at(theta_i, 0.0);
  const Vec3 wr = direction_at(theta_r, phi);
  return f_r(brdf, wi, wr, Vec3::UnitZ());
}

}  // namespace lrcs
