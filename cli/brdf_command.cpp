#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "base/input_error.h"
#include "brdf/brdf_table.h"
#include "cli/commands.h"
#include "cli/flag_words.h"
#include "view/brdf_plot.h"

namespace lrcs {
namespace {

struct Options {
  std::string material, theta_i = "0,30,60", step = "10", png;
};

// Not a number, at which the curve breaks, where it was not measured.
double f_r_if_known(const Brdf& brdf, double theta_i, double theta_r) {
  try {
    return f_r_angles(brdf, theta_i, std::abs(theta_r), theta_r < 0.0 ? std::numbers::pi : 0.0);
  } catch (const NotMeasured&) {
    return std::nan("");
  }
}

// f_r in the plane of incidence, as in the table: a negative theta_r is the specular side.
BrdfCurve curve_of(const Brdf& brdf, double theta_i_deg) {
  BrdfCurve curve;
  curve.theta_i_deg = theta_i_deg;
  for (int k = -170; k <= 170; ++k) {
    const double theta_r_deg = 0.5 * k;
    curve.theta_r_deg.push_back(theta_r_deg);
    curve.f_r_per_sr.push_back(f_r_if_known(brdf, theta_i_deg * degree, theta_r_deg * degree));
  }
  return curve;
}

std::string table_of(const Material& material, const std::vector<double>& theta_i_deg, const std::string& step) {
  const double step_deg = number_from_words(step, "--step");
  if (!(step_deg >= 0.01 && step_deg <= 80.0))
    throw InputError(fmt::format("--step: expected 0.01 to 80 deg, found {}", step));
  try {
    return brdf_table(material, theta_i_deg, step_deg);
  } catch (const std::domain_error& too_many_rows) {
    throw InputError(fmt::format("--step: {}", too_many_rows.what()));
  }
}

void print_table(const Options& options, bool quiet) {
  const Material material = material_from_argument(options.material);
  const auto theta_i_deg = angles_from_words(options.theta_i, "--theta-i", incidence_domain);
  const std::string table = table_of(material, theta_i_deg, options.step);
  if (!options.png.empty()) {
    std::vector<BrdfCurve> curves;
    curves.reserve(theta_i_deg.size());
    for (const double angle : theta_i_deg) curves.push_back(curve_of(material.brdf, angle));
    draw_brdf_plot(options.png, curves, fmt::format("BRDF of {} in the plane of incidence", material.name));
  }
  fmt::print("{}", table);
  if (!quiet)
    for (const auto& warning : brdf_warnings(material.brdf)) fmt::print(stderr, "lrcs: warning: {}\n", warning);
}

}  // namespace

void add_brdf_commands(CLI::App& app, Common& common) {
  const auto options = std::make_shared<Options>();
  CLI::App* brdf = app.add_subcommand("brdf", "Table (stdout) and plot of a material's BRDF, in plane");
  brdf->add_option("material", options->material, "lambert:REFLECTANCE, a library name, or a material file")
      ->required();
  brdf->add_option("--theta-i", options->theta_i, "Incidence angles [deg]: A,B,C or FROM:TO:STEP (default 0,30,60)");
  brdf->add_option("--step", options->step, "Step of the scattering angle [deg] (default 10)");
  brdf->add_option("-o,--output", options->png, "Draw the curves into this PNG file");
  add_common_flags(*brdf, common);
  brdf->callback([options, &common] { print_table(*options, common.quiet); });

  CLI::App* materials = app.add_subcommand("materials", "The built-in materials");
  add_common_flags(*materials, common);
  materials->callback([] { fmt::print("{}", materials_table()); });
}

}  // namespace lrcs
