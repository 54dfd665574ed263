#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <stdexcept>

#include "base/input_error.h"
#include "brdf/brdf_table.h"
#include "cli/brdf_pictures.h"
#include "cli/commands.h"
#include "cli/flag_words.h"

namespace lrcs {
namespace {

struct BrdfOptions {
  std::string material, theta_i = "0,30,60", step = "10";
  std::vector<std::string> compared;
  BrdfPictures pictures;
};

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

void print_table(const BrdfOptions& options, bool quiet) {
  const Material material = material_from_argument(options.material);
  const auto theta_i_deg = angles_from_words(options.theta_i, "--theta-i", incidence_domain);
  const std::string table = table_of(material, theta_i_deg, options.step);
  std::vector<Material> materials{material};
  for (const auto& words : options.compared) materials.push_back(material_from_argument(words));
  require_drawable(options.pictures, materials);
  draw_brdf_pictures(options.pictures, materials, theta_i_deg);
  fmt::print("{}", table);
  if (!quiet)
    for (const auto& warning : brdf_warnings(material.brdf)) fmt::print(stderr, "lrcs: warning: {}\n", warning);
}

void add_picture_flags(CLI::App& brdf, BrdfOptions& options) {
  brdf.add_option("-o,--output", options.pictures.curves, "Draw the curves into this file, .png or .svg");
  brdf.add_option("--shadowing", options.pictures.shadowing,
                  "Draw the shadowing function G into this file, .png or .svg (models that have one)");
  brdf.add_option("--with", options.compared, "Beside MATERIAL in --output and --shadowing; may be repeated")
      ->allow_extra_args(false);
  brdf.add_option(
      "--surface", options.pictures.surface,
      "Draw f_r over all scattering directions, at the first incidence angle, into this file, .png or .svg");
  brdf.add_option("--surface-shadowing", options.pictures.surface_shadowing, "The same of G");
}

}  // namespace

void add_brdf_commands(CLI::App& app, Common& common) {
  const auto options = std::make_shared<BrdfOptions>();
  CLI::App* brdf = app.add_subcommand("brdf", "Table (stdout) and pictures of a material's BRDF");
  brdf->add_option("material", options->material, "lambert:REFLECTANCE, a library name, or a material file")
      ->required();
  brdf->add_option("--theta-i", options->theta_i, "Incidence angles [deg]: A,B,C or FROM:TO:STEP (default 0,30,60)");
  brdf->add_option("--step", options->step, "Step of the scattering angle [deg] (default 10)");
  add_picture_flags(*brdf, *options);
  add_common_flags(*brdf, common);
  brdf->callback([options, &common] { print_table(*options, common.quiet); });

  CLI::App* materials = app.add_subcommand("materials", "The built-in materials");
  add_common_flags(*materials, common);
  materials->callback([] { fmt::print("{}", materials_table()); });
}

}  // namespace lrcs
