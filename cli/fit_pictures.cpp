#include "cli/fit_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/direction.h"
#include "brdf/brdf_form.h"
#include "cli/plane_curves.h"
#include "view/fit_plot.h"
#include "view/incidence_family.h"
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

// To 0.01 deg, below 90: at 90 models may be infinite. [deg]
double rounded_theta_i(const BrdfSample& s) {
  return std::min(std::round(s.theta_i / degree * 100.0), 8999.0) / 100.0;
}

using ByIncidence = std::map<double, std::vector<const BrdfSample*>>;  // rounded theta_i [deg]

ByIncidence samples_in_plane(const BrdfMeasurement& measurement) {
  ByIncidence groups;
  for (const BrdfSample& s : measurement.samples)
    if (is_in_plane(s)) groups[rounded_theta_i(s)].push_back(&s);
  return groups;
}

// All, or where that is too many spread ones of those with at least half as many samples as the richest.
std::vector<double> chosen_incidences(const ByIncidence& groups, std::size_t most) {
  std::size_t richest = 0;
  for (const auto& [theta_i_deg, samples] : groups) richest = std::max(richest, samples.size());
  std::vector<double> all, chosen;
  for (const auto& [theta_i_deg, samples] : groups)
    if (groups.size() <= most || 2 * samples.size() >= richest) all.push_back(theta_i_deg);
  for (const std::size_t k : spread_choice(all.size(), most)) chosen.push_back(all[k]);
  return chosen;
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

// What a fitted value misses a sample by: ln(fitted/measured), not a number where there is none; or the difference of
// the f_r cos theta_r in percent of the largest.
double residual_of(const BrdfSample& s, double fitted, Residual residual, double largest) {
  if (residual == Residual::linear) return 100.0 * (fitted - s.f_r) * std::cos(s.theta_r) / largest;
  return fitted > 0.0 && s.f_r > 0.0 ? std::log(fitted / s.f_r) : std::numeric_limits<double>::quiet_NaN();
}

FitCurve curve_of(const Brdf& brdf, double theta_i_deg, const std::vector<const BrdfSample*>& samples,
                  Residual residual, double largest) {
  FitCurve curve;
  curve.theta_i_deg = theta_i_deg;
  double last = 0.0;
  for (const BrdfSample* s : samples) {
    curve.measured_theta_r_deg.push_back(signed_theta_r(*s));
    curve.measured_f_r_per_sr.push_back(s->f_r);
    curve.residual.push_back(residual_of(*s, f_r_angles(brdf, s->theta_i, s->theta_r, s->phi), residual, largest));
    last = std::max(last, std::abs(curve.measured_theta_r_deg.back()));
  }
  curve.fitted_theta_r_deg = angles_to_draw(theta_i_deg, last);
  for (const double r : curve.fitted_theta_r_deg) curve.fitted_f_r_per_sr.push_back(f_r_in_plane(brdf, theta_i_deg, r));
  return curve;
}

std::string note_of(const BrdfFit& fit, const BrdfMeasurement& measurement, const ByIncidence& groups,
                    std::size_t drawn) {
  std::string note = fmt::format("E = {:.4g} %", fit.e_percent);
  std::size_t in_plane_samples = 0;
  for (const auto& [theta_i_deg, samples] : groups) in_plane_samples += samples.size();
  if (in_plane_samples < measurement.samples.size())
    note +=
        fmt::format("; {} of {} samples lie in the plane of incidence", in_plane_samples, measurement.samples.size());
  const std::string choice = choice_note(drawn, groups.size());
  return choice.empty() ? note : note + "; " + choice;
}

void draw_fit(const fs::path& file, const BrdfFit& fit, const BrdfMeasurement& measurement, Residual residual,
              const ByIncidence& groups) {
  const auto incidences = chosen_incidences(groups, most_incidences_of_a_fit);
  FitPicture picture;
  picture.title = fmt::format("{}: {}", measurement.name, find_brdf_form(fit.form)->title);
  picture.note = note_of(fit, measurement, groups, incidences.size());
  picture.residuals = residual == Residual::linear ? ResidualKind::percent_of_largest : ResidualKind::logarithm;
  const double largest = largest_f_cos(measurement);
  for (const double theta_i_deg : incidences)
    picture.curves.push_back(curve_of(fit.material.brdf, theta_i_deg, groups.at(theta_i_deg), residual, largest));
  draw_fit_plot(file, picture);
}

void draw_shadowing(const fs::path& file, const BrdfFit& fit, const ByIncidence& groups) {
  const auto incidences = chosen_incidences(groups, most_incidences_of_a_family);
  draw_shadowing_plot(file, {shadowing_curves(fit.form, fit.material.brdf, incidences)},
                      fmt::format("Shadowing function fitted to {}", fit.material.name),
                      choice_note(incidences.size(), groups.size()));
}

}  // namespace

FitPictureFiles picture_files(const fs::path& material, const std::string& ending) {
  return {fs::path(material).replace_extension(ending),
          material.parent_path() / (material.stem().string() + "-shadowing" + ending)};
}

bool is_measured_in_plane(const BrdfMeasurement& measurement) {
  return std::any_of(measurement.samples.begin(), measurement.samples.end(), is_in_plane);
}

std::vector<fs::path> draw_fit_pictures(const FitPictureFiles& files, const BrdfFit& fit,
                                        const BrdfMeasurement& measurement, Residual residual) {
  const ByIncidence groups = samples_in_plane(measurement);
  if (groups.empty()) return {};
  draw_fit(files.fit, fit, measurement, residual, groups);
  if (!has_shadowing(fit.material.brdf)) return {files.fit};
  draw_shadowing(files.shadowing, fit, groups);
  return {files.fit, files.shadowing};
}

}  // namespace lrcs
