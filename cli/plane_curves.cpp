#include "cli/plane_curves.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "base/direction.h"
#include "brdf/shadowing.h"

namespace lrcs {
namespace {

double phi_of(double theta_r_deg) {
  return theta_r_deg < 0.0 ? std::numbers::pi : 0.0;
}

double shadowing_in_plane(const Brdf& brdf, double theta_i_deg, double theta_r_deg) {
  return shadowing_angles(brdf, theta_i_deg * degree, std::abs(theta_r_deg) * degree, phi_of(theta_r_deg)).value();
}

}  // namespace

double f_r_in_plane(const Brdf& brdf, double theta_i_deg, double theta_r_deg) {
  return f_r_angles(brdf, theta_i_deg * degree, std::abs(theta_r_deg) * degree, phi_of(theta_r_deg));
}

std::vector<double> half_degrees(int steps) {
  std::vector<double> theta_r_deg;
  for (int k = -steps; k <= steps; ++k) theta_r_deg.push_back(0.5 * k);
  return theta_r_deg;
}

bool has_shadowing(const Brdf& brdf) {
  return shadowing_angles(brdf, 0.0, 0.0, 0.0).has_value();
}

ShadowingCurves shadowing_curves(const std::string& material, const Brdf& brdf,
                                 const std::vector<double>& theta_i_deg) {
  constexpr int last = 178;  // 89 deg
  ShadowingCurves curves{material, {}};
  for (const double i_deg : theta_i_deg) {
    ShadowingCurve curve{i_deg, half_degrees(last), {}};
    for (const double r_deg : curve.theta_r_deg) curve.shadowing.push_back(shadowing_in_plane(brdf, i_deg, r_deg));
    curves.curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace lrcs
