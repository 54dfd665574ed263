#include "cli/fit_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "base/direction.h"
#include "brdf/brdf_form.h"
#include "brdf/shadowing.h"
#include "view/fit_plot.h"
#include "view/shadowing_plot.h"

namespace lrcs {
namespace {

namespace fs = std::filesystem;
constexpr double in_plane = 0.5;  // [deg] from phi 0 or 180

// As in the tables: a negative theta_r is the specular side. [deg]
double signed_theta_r(const BrdfSample& s) {
  return (std::cos(s.phi) < 0.0 ? -s.theta_r : s.theta_r) / degree;
}

bool is_in_plane(const BrdfSample& s) {
  return std::abs(std::sin(s.phi)) <= std::sin(in_plane * degree) || s.theta_r == 0.0 || s.theta_i == 0.0;
}

double model_at(const Brdf& brdf, double theta_i_deg, double signed_theta_r_deg) {
  return f_r_angles(brdf, theta_i_deg * degree, std::abs(signed_theta_r_deg) * degree,
                    signed_theta_r_deg < 0.0 ? std::numbers::pi : 0.0);
}

using ByIncidence = std::map<double, std::vector<const BrdfSample*>>;  // theta_i, to 0.01 deg [deg]

ByIncidence samples_in_plane(const BrdfMeasurement& measurement) {
  ByIncidence groups;
  for (const BrdfSample& s : measurement.samples)
    if (is_in_plane(s)) groups[std::round(s.theta_i / degree * 100.0) / 100.0].push_back(&s);
  return groups;
}

double largest_f_cos(const BrdfMeasurement& measurement) {
  double largest = 0.0;
  for (const BrdfSample& s : measurement.samples) largest = std::max(largest, s.f_r * std::cos(s.theta_r));
  return largest;
}

// Every half degree, and every tenth about the specular and the retro direction, where lobes stand.
std::vector<double> angles_to_draw(double theta_i_deg, double last_deg) {
  std::vector<double> angles;
  const int steps = static_cast<int>(std::floor(last_deg * 10.0));
  for (int k = -steps; k <= steps; ++k) {
    const double angle = 0.1 * k;
    if (k % 5 == 0 || std::abs(std::abs(angle) - theta_i_deg) < 3.0) angles.push_back(angle);
  }
  return angles;
}

FitCurve curve_of(const Brdf& brdf, double theta_i_deg, const std::vector<const BrdfSample*>& samples, double scale) {
  FitCurve curve;
  curve.theta_i_deg = theta_i_deg;
  double last = 0.0;
  for (const BrdfSample* s : samples) {
    const double f = f_r_angles(brdf, s->theta_i, s->theta_r, s->phi);
    curve.measured_theta_r_deg.push_back(signed_theta_r(*s));
    curve.measured_f_r_per_sr.push_back(s->f_r);
    curve.residual_percent.push_back(100.0 * (f - s->f_r) * std::cos(s->theta_r) / scale);
    last = std::max(last, std::abs(curve.measured_theta_r_deg.back()));
  }
  curve.fitted_theta_r_deg = angles_to_draw(theta_i_deg, last);
  for (const double r : curve.fitted_theta_r_deg) curve.fitted_f_r_per_sr.push_back(model_at(brdf, theta_i_deg, r));
  return curve;
}

fs::path draw_fit(const fs::path& material, const BrdfFit& fit, const BrdfMeasurement& measurement,
                  const ByIncidence& groups) {
  FitPicture picture;
  picture.title = fmt::format("{}: {}", measurement.name, fit.form);
  picture.note = fmt::format("E = {:.4g} %", fit.e_percent);
  std::size_t drawn = 0;
  for (const auto& [theta_i_deg, samples] : groups) {
    picture.curves.push_back(curve_of(fit.material.brdf, theta_i_deg, samples, largest_f_cos(measurement)));
    drawn += samples.size();
  }
  if (drawn < measurement.samples.size())
    picture.note += fmt::format("; {} of {} samples lie in the plane of incidence", drawn, measurement.samples.size());
  fs::path png = fs::path(material).replace_extension(".png");
  draw_fit_plot(png, picture);
  return png;
}

fs::path draw_shadowing(const fs::path& material, const BrdfFit& fit, const ByIncidence& groups) {
  ShadowingCurves curves{fit.form, {}};
  for (const auto& [theta_i_deg, samples] : groups) {
    ShadowingCurve curve{theta_i_deg, {}, {}};
    for (int k = -178; k <= 178; ++k) {
      const double r = 0.5 * k;
      curve.theta_r_deg.push_back(r);
      curve.shadowing.push_back(shadowing_angles(fit.material.brdf, theta_i_deg * degree, std::abs(r) * degree,
                                                 r < 0.0 ? std::numbers::pi : 0.0)
                                    .value());
    }
    curves.curves.push_back(std::move(curve));
  }
  fs::path png = material.parent_path() / (material.stem().string() + "-shadowing.png");
  draw_shadowing_plot(png, {curves}, fmt::format("Shadowing function fitted to {}", fit.material.name));
  return png;
}

}  // namespace

std::vector<fs::path> draw_fit_pictures(const fs::path& material, const BrdfFit& fit,
                                        const BrdfMeasurement& measurement) {
  const ByIncidence groups = samples_in_plane(measurement);
  if (groups.empty()) return {};
  std::vector<fs::path> drawn{draw_fit(material, fit, measurement, groups)};
  if (shadowing_angles(fit.material.brdf, 0.0, 0.0, 0.0)) drawn.push_back(draw_shadowing(material, fit, groups));
  return drawn;
}

}  // namespace lrcs
