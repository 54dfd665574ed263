#include <fmt/format.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>

#include "cli/commands.h"
#include "cli/facet_results.h"
#include "cli/flag_words.h"
#include "cli/font_warning.h"
#include "cli/past_run.h"
#include "cli/progress_bar.h"
#include "cli/rows_ahead.h"
#include "cli/sweep_cuts.h"
#include "lrcs/convexity.h"
#include "lrcs/facet_sections.h"
#include "view/aspect_view.h"
#include "view/aspect_window.h"
#include "view/text_bitmap.h"

namespace lrcs {
namespace {

struct Options {
  std::string input, png, size = "1600x1200", colour = "contribution", scale = "dB", per = "area";
  std::int64_t aspect = 0;
  double range = 40.0;
};

std::size_t row_from_flag(std::int64_t row, std::size_t rows) {
  if (row < 0 || row >= static_cast<std::int64_t>(rows))
    throw InputError(fmt::format("--aspect: expected a row of the sweep, 0 to {}, found {}", rows - 1, row));
  return static_cast<std::size_t>(row);
}

// A scene file is swept first, but not in vain.
PastRun run_of(const Options& options, const Common& common) {
  if (std::filesystem::is_directory(options.input)) return read_past_run(options.input);
  PastRun run;
  run.scene = read_scene(options.input);
  (void)row_from_flag(options.aspect, run.scene.directions.size());
  run.loaded = load_target(run.scene);
  const std::vector<Aspect> aspects = aspects_of(run.scene.directions, run.scene.receiver);
  ProgressBar bar(aspects.size(), "directions", !common.quiet);
  run.rows = run_sweep(run.loaded.target, aspects, common.threads,
                       {[&](std::size_t done) { bar.update(done); }, {}, {}}, nullptr, run.scene.relative_accuracy);
  return run;
}

FacetShowing showing_of(const Options& options) {
  FacetShowing showing;
  const std::array<const char*, 5> quantities{"contribution", "seen", "incidence", "material", "part"};
  for (std::size_t k = 0; k < quantities.size(); ++k)
    if (options.colour == quantities[k]) showing.quantity = static_cast<FacetQuantity>(k);
  showing.in_decibels = options.scale == "dB";
  showing.per_area = options.per == "area";
  if (!(options.range >= 1.0 && options.range <= 200.0))
    throw InputError(fmt::format("--range: expected 1 to 200 dB, found {}", options.range));
  showing.darkest = -options.range;
  return showing;
}

// A window may stay open for long: what main would say at its end is said before.
void warn_of_names(const ViewedSweep& sweep, const Target& target, const Common& common) {
  std::vector<std::string> names = target.mesh.part.names;
  names.push_back(sweep.title);
  for (const Material& material : target.materials) names.push_back(material.name);
  for (const std::string& name : names) note_letters_without_font(name);
  warn_of_letters_without_font(common);
}

[[noreturn]] void end_without_display() {
  fmt::print(stderr, "lrcs: the window is gone: its X server has ended\n");
  std::_Exit(1);
}

void view(const Options& options, const Common& common) {
  const auto [width, height] = size_from_words(options.size, "--size", {640, 360});
  if (!options.png.empty()) require_output_file(options.png, "--png", {".png"});
  const FacetShowing showing = showing_of(options);
  const PastRun run = run_of(options, common);
  const std::size_t first = row_from_flag(options.aspect, run.rows.size());
  std::optional<tbb::global_control> allowed;
  if (common.threads != 0) allowed.emplace(tbb::global_control::max_allowed_parallelism, common.threads);
  const Target& target = run.loaded.target;
  std::optional<Visibility> visibility;
  if (!is_convex_body(target.mesh)) visibility.emplace(target.mesh);
  FacetSections sections(target, visibility ? &*visibility : nullptr);
  const ViewedSweep sweep = viewed_sweep(run.rows, target.mesh, title_of(run.scene));
  const AspectView::Compute compute = [&](std::size_t row) {
    const CrossSection& section = sections.at(run.rows[row].aspect);
    return facet_result(target, {run.rows[row].aspect, section.sigma, section.seen_area}, section);
  };
  if (!options.png.empty()) {
    AspectView view(sweep, compute, first);
    view.show(showing);
    write_png(options.png, view.picture(width, height));
    return;
  }
  RowsAhead ahead(compute, run.rows.size());
  const bool looks_ahead = common.threads != 1;
  AspectView view(
      sweep, [&](std::size_t row) { return looks_ahead ? ahead.at(row) : compute(row); }, first);
  view.show(showing);
  warn_of_names(sweep, target, common);
  const bool is_folder = std::filesystem::is_directory(options.input);
  show_aspect_window(
      view, "lrcs: " + sweep.title, is_folder ? options.input : ".",
      [](const std::string& line) { fmt::print("{}\n", line), std::fflush(stdout); }, end_without_display);
}

}  // namespace

void add_view_command(CLI::App& app, Common& common) {
  const auto options = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand("view", "Shows which facets the return comes from, row by row of a sweep");
  verb->add_option("input", options->input, "Folder that lrcs sweep wrote, or SCENE.yaml")->required();
  verb->add_option("--png", options->png, "Draws a picture into this file instead of opening a window");
  verb->add_option("--size", options->size, "Of the picture: WIDTHxHEIGHT [pixel] (default 1600x1200)");
  verb->add_option("--aspect", options->aspect, "Row of the sweep to begin with, from 0 (default 0)");
  verb->add_option("--colour", options->colour, "What colours show (default contribution)")
      ->check(CLI::IsMember({"contribution", "seen", "incidence", "material", "part"}));
  verb->add_option("--scale", options->scale, "Of contributions (default dB)")->check(CLI::IsMember({"dB", "linear"}));
  verb->add_option("--per", options->per, "Contributions over the facet's area, or of the facet (default area)")
      ->check(CLI::IsMember({"area", "facet"}));
  verb->add_option("--range", options->range, "Decibels that colours span (default 40)");
  add_common_flags(*verb, common);
  verb->callback([options, &common] { view(*options, common); });
}

}  // namespace lrcs
