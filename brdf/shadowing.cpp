#include "brdf/shadowing.h"

#include "brdf/direction_at.h"

namespace lrcs {

std::optional<double> shadowing_angles(const Brdf& brdf, double theta_i, double theta_r, double phi) {
  const Vec3 wi = direction_at(theta_i, 0.0);
  const Vec3 wr = direction_at(theta_r, phi);
  const Vec3 n = Vec3::UnitZ();
  return std::visit(
      [&](const auto& model) -> std::optional<double> {
        if constexpr (requires { model.shadowing(wi, wr, n); })
          return model.shadowing(wi, wr, n);
        else
          return std::nullopt;
      },
      brdf);
}

}  // namespace lrcs
