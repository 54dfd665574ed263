#include "brdf/brdf_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "base/length.h"
#include "brdf/brdf_form.h"
#include "brdf/library.h"
#include "brdf/shadowing.h"

namespace lrcs {
namespace {

constexpr double most_rows = 100000.0;
constexpr double albedo_accuracy = 1e-4;           // relative: three digits are shown
constexpr double albedo_accuracy_shown = 1e-6;     // relative: seven digits are
constexpr double model_accuracy = 1e-12;           // relative: of f_r, tests/brdf/high_precision_test.cpp
constexpr double albedo_accuracy_measured = 1e-2;  // relative: between samples a tabulated one has kinks

void require_domain(const std::vector<double>& theta_i_deg, double step_deg, double largest_deg) {
  const auto is_angle = [](double deg) { return deg >= 0.0 && deg < 90.0; };
  if (theta_i_deg.empty() || !std::all_of(theta_i_deg.begin(), theta_i_deg.end(), is_angle))
    throw std::domain_error("expected angles of incidence in [0, 90) deg");
  if (!is_angle(largest_deg)) throw std::domain_error("expected a largest theta_r in [0, 90) deg");
  const double rows = (2.0 * largest_deg / step_deg + 1.0) * static_cast<double>(theta_i_deg.size());
  if (!(step_deg > 0.0) || !(rows <= most_rows))
    throw std::domain_error(fmt::format("expected a step > 0 deg that gives at most {} rows", most_rows));
}

// The albedo; where not all directions were measured, that of those which were: a lower bound.
struct KnownAlbedo {
  Estimate value;
  bool all = true;
};

KnownAlbedo known_albedo(const Brdf& brdf, double theta_i, double accuracy) {
  const auto* tabulated = std::get_if<Tabulated>(&brdf);
  if (tabulated == nullptr) return {albedo(brdf, theta_i, accuracy)};
  accuracy = std::max(accuracy, albedo_accuracy_measured);
  try {
    return {albedo(brdf, theta_i, accuracy)};
  } catch (const NotMeasured&) {
    return {albedo(tabulated->with(Outside::zero), theta_i, accuracy), false};
  }
}

std::string albedo_line(const Brdf& brdf, double theta_i_deg) {
  const auto [a, all] = known_albedo(brdf, theta_i_deg * degree, albedo_accuracy_shown);
  return fmt::format("# albedo at theta_i = {} deg: {}{:.7g} (error below {:.1g}{})\n", theta_i_deg,
                     all ? "" : "at least ", a.value, a.bound, all ? "" : "; not all directions were measured");
}

// The rows of one angle of incidence, and those that cannot be, as comment lines.
struct Rows {
  std::string rows, left_out;
};

Rows rows_of(const Brdf& brdf, double i_deg, double step_deg, int steps) {
  Rows text;
  std::vector<double> missing;
  for (int k = -steps; k <= steps; ++k) {
    const double r_deg = k * step_deg;
    try {
      const double f_r = f_r_angles(brdf, i_deg * degree, r_deg * degree, 0.0);
      text.rows += fmt::format("{},{},0,{},{}\n", i_deg, r_deg, f_r,
                               shadowing_angles(brdf, i_deg * degree, r_deg * degree, 0.0).value_or(1.0));
    } catch (const NotMeasured&) {
      missing.push_back(r_deg);
    }
  }
  if (!missing.empty())
    text.left_out =
        fmt::format("# not measured, left out: theta_i = {} deg, theta_r = {} deg\n", i_deg, fmt::join(missing, " "));
  return text;
}

std::string header(const Material& material, const std::vector<double>& theta_i_deg) {
  std::string text = fmt::format("# material: {}: {}\n", material.name, description_of(material.brdf));
  if (!material.source.empty()) text += fmt::format("# source: {}\n", material.source);
  if (material.wavelength > 0.0) text += fmt::format("# wavelength: {}\n", text_of_length(material.wavelength, "um"));
  text += "# azimuth_of_specular: 180\n# value: brdf\n";
  if (const auto* tabulated = std::get_if<Tabulated>(&material.brdf))
    for (const std::string& note : tabulated->measurement().notes) text += fmt::format("# note: {}\n", note);
  for (const double deg : theta_i_deg) text += albedo_line(material.brdf, deg);
  for (const std::string& warning : brdf_warnings(material.brdf)) text += fmt::format("# warning: {}\n", warning);
  return text;
}

// Both at whole degrees; of a tabulated one at every tenth, where the samples do not know better.
void add_albedo_warnings(const Brdf& brdf, std::vector<std::string>& warnings) {
  std::optional<int> first_above_one, first_unknown;
  double largest = 0.0;
  const int step = std::holds_alternative<Tabulated>(brdf) ? 10 : 1;
  int last_above_one = 0, at_largest = 0;
  for (int deg = 0; deg < 90; deg += step) {
    const auto [a, all] = known_albedo(brdf, deg * degree, albedo_accuracy);
    if (!all && !first_unknown) first_unknown = deg;
    if (a.value > largest) largest = a.value, at_largest = deg;
    if (!(a.value - a.bound > 1.0)) continue;
    if (!first_above_one) first_above_one = deg;
    last_above_one = deg;
  }
  if (first_above_one)
    warnings.push_back(fmt::format(
        "the albedo passes 1 {} ({:.3g} at {} deg)",
        last_above_one + step >= 90 ? fmt::format("from theta_i = {} deg on", *first_above_one)
                                    : fmt::format("between theta_i = {} and {} deg", *first_above_one, last_above_one),
        largest, at_largest));
  if (first_unknown)
    warnings.push_back(fmt::format(
        "not all directions were measured, from theta_i = {} deg on: albedos there are lower bounds, rows are left out",
        *first_unknown));
}

std::optional<std::string> reciprocity_warning(const Brdf& brdf) {
  if (std::visit([](const auto& model) { return model.is_reciprocal; }, brdf)) return std::nullopt;
  double worst = 0.0;
  std::string where;
  for (int i = 5; i <= 80; i += 5)
    for (int r = 0; r < i; r += 5)
      for (int phi = 0; phi <= 180; phi += 15) {
        const double there = f_r_angles(brdf, i * degree, r * degree, phi * degree);
        const double back = f_r_angles(brdf, r * degree, i * degree, phi * degree);
        const double larger = std::max(there, back);
        if (larger <= 0.0 || std::abs(there - back) <= worst * larger) continue;
        worst = std::abs(there - back) / larger;
        where = fmt::format("theta {} and {} deg, phi {} deg", i, r, phi);
      }
  if (worst <= model_accuracy) return std::nullopt;
  return fmt::format("not reciprocal: f_r changes by up to {:.2g} % when the directions are exchanged ({})",
                     100.0 * worst, where);
}

}  // namespace

std::string description_of(const Brdf& brdf) {
  if (const auto* tabulated = std::get_if<Tabulated>(&brdf)) return tabulated->description();
  const BrdfWords words = words_of(brdf);
  std::string text = words.form->name;
  for (std::size_t k = 0; k < words.values.size(); ++k)
    text += fmt::format(" {}={}", words.form->parameters[k], words.values[k]);
  if (words.form->has_azimuth_of_specular) text += fmt::format(" azimuth_of_specular={}", words.azimuth_of_specular);
  return text;
}

std::vector<std::string> brdf_warnings(const Brdf& brdf) {
  std::vector<std::string> warnings;
  if (const auto* tabulated = std::get_if<Tabulated>(&brdf)) warnings = tabulated->measurement().warnings;
  add_albedo_warnings(brdf, warnings);
  if (auto warning = reciprocity_warning(brdf)) warnings.push_back(*warning);
  return warnings;
}

std::string brdf_table(const Material& material, const std::vector<double>& theta_i_deg, double step_deg,
                       double largest_theta_r_deg) {
  require_domain(theta_i_deg, step_deg, largest_theta_r_deg);
  const int steps = static_cast<int>(std::floor(largest_theta_r_deg / step_deg));
  std::string text = header(material, theta_i_deg);
  std::string rows;
  for (const double deg : theta_i_deg) {
    const Rows of_one = rows_of(material.brdf, deg, step_deg, steps);
    text += of_one.left_out;
    rows += of_one.rows;
  }
  return text + "theta_i_deg,theta_r_deg,phi_deg,f_r_per_sr,G\n" + rows;
}

std::string materials_table() {
  std::string text;
  for (const Material& m : material_library())
    text += fmt::format("{:<18} {:<8} {}\n{:>18} {}\n", m.name, text_of_length(m.wavelength, "um"),
                        description_of(m.brdf), "", m.source);
  return text;
}

}  // namespace lrcs
