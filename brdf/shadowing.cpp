#include "brdf/shadowing.h"

#include <cmath>

namespace lrcs {

std::optional<double> shadowing_angles(const Brdf& brdf, double theta_i, double theta_r, double phi) {
  const Vec3 wi(std::sin(theta_i), 0.0, std::cos(theta_i));
  const Vec3 wr(std::sin(theta_r) * std::cos(phi), std::sin(theta_r) * std::sin(phi), std::cos(theta_r));
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
