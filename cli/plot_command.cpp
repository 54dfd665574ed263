#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "base/nearest_name.h"
#include "cli/commands.h"
#include "cli/flag_words.h"
#include "cli/part_stack.h"
#include "cli/plotted_sweep.h"
#include "cli/progress_bar.h"
#include "cli/sweep_map.h"
#include "lrcs/sweep_csv.h"
#include "view/plot_file.h"
#include "view/sphere_plot.h"

namespace lrcs {
namespace {

struct PlotOptions {
  std::vector<std::string> inputs, labels;
  std::string output = "plot.png", kind = "cut", title, size;
  // As words; "": not given.
  std::string azimuth, elevation, from, floor;
};

// Letters and lines are as large as on the usual size, as much as that is enlarged to fit.
Canvas canvas_for(const PlotOptions& options) {
  const PictureSize usual = options.kind == "polar" ? PictureSize{1200, 1200} : PictureSize{1600, 1000};
  const PictureSize size = options.size.empty() ? usual : size_from_words(options.size, "--size", {400, 250});
  const double enlarged = std::min(static_cast<double>(size.width) / usual.width,  //
                                   static_cast<double>(size.height) / usual.height);
  return plot_canvas(options.output, size.width, size.height, enlarged);
}

std::optional<double> number_if_given(const std::string& words, const char* flag) {
  return words.empty() ? std::nullopt : std::optional(number_from_words(words, flag));
}

CutChoice cut_choice(const PlotOptions& options) {
  if (!options.azimuth.empty() && !options.elevation.empty())
    throw InputError("--azimuth: expected either --azimuth or --elevation, found both");
  return {number_if_given(options.azimuth, "--azimuth"), number_if_given(options.elevation, "--elevation")};
}

void require_kind(const std::string& kind) {
  const std::vector<std::string> kinds{"cut", "polar", "map", "sphere", "parts"};
  if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
    throw InputError(fmt::format("--kind: expected cut, polar, map, sphere or parts, found '{}'{}", kind,
                                 did_you_mean(kind, kinds)));
}

// Flags that say nothing to this kind of plot are errors.
void require_fitting_flags(const PlotOptions& options) {
  const bool is_curves = options.kind == "cut" || options.kind == "polar", is_parts = options.kind == "parts";
  const auto refuse = [&](const std::string& words, const char* flag, bool allowed, const char* kinds) {
    if (!words.empty() && !allowed)
      throw InputError(fmt::format("{}: belongs to --kind {}, found beside --kind {}", flag, kinds, options.kind));
  };
  refuse(options.azimuth, "--azimuth", is_curves || is_parts, "cut, polar or parts");
  refuse(options.elevation, "--elevation", is_curves || is_parts, "cut, polar or parts");
  refuse(options.labels.empty() ? "" : options.labels.front(), "--label", is_curves, "cut or polar");
  refuse(options.from, "--from", options.kind == "sphere", "sphere");
  refuse(options.floor, "--floor", !is_parts, "cut, polar, map or sphere");
  if (!is_curves && options.inputs.size() > 1)
    throw InputError(fmt::format("--kind {}: expected one sweep, found {}", options.kind, options.inputs.size()));
  if (options.inputs.size() > most_curves)
    throw InputError(
        fmt::format("expected at most {} sweeps to compare, found {}", most_curves, options.inputs.size()));
  if (!options.labels.empty() && options.labels.size() != options.inputs.size())
    throw InputError(fmt::format("--label: expected one for each of {} sweeps, found {}", options.inputs.size(),
                                 options.labels.size()));
}

std::optional<double> checked_floor(const PlotOptions& options, const std::vector<PlottedSweep>& sweeps) {
  const auto floor = number_if_given(options.floor, "--floor");
  double highest = 0.0;
  for (const PlottedSweep& sweep : sweeps)
    for (const SweepRow& row : sweep.rows) highest = std::max(highest, row.sigma.value);
  constexpr double deepest = 300.0;  // [dB]
  const double top = dbsm(highest);
  if (floor && highest > 0.0 && (*floor >= top || *floor < top - deepest))
    throw InputError(fmt::format(
        "--floor: expected less than the highest LRCS, {:.6g} dBsm, by {} dB at most, found {}", top, deepest, *floor));
  return floor;
}

std::string plot_title(const PlotOptions& options, const std::vector<PlottedSweep>& sweeps) {
  if (!options.title.empty()) return options.title;
  const auto monostatic = static_cast<std::size_t>(
      std::count_if(sweeps.begin(), sweeps.end(), [](const PlottedSweep& sweep) { return sweep.is_monostatic(); }));
  std::string title = monostatic == sweeps.size() ? "Monostatic LRCS" : monostatic == 0 ? "Bistatic LRCS" : "LRCS";
  if (options.kind == "parts") title += " by part";
  const PlottedSweep& first = sweeps.front();
  const bool one_target = std::all_of(sweeps.begin(), sweeps.end(),
                                      [&](const PlottedSweep& sweep) { return sweep.target == first.target; });
  if (sweeps.size() == 1 && first.target.empty()) return title + " of " + first.label;
  return one_target && !first.target.empty() ? title + " of " + first.target : title;
}

// What is told by the axis where every curve is at the same fixed angle: "azimuth [deg] at elevation 20 deg".
std::string axis_title(const Cuts& cuts) {
  const std::string& cut = cuts.cuts.front().curve.label;
  return cuts.cuts.size() == 1 && cuts.angle != CutAngle::other ? fmt::format("{} at {}", cuts.axis, cut) : cuts.axis;
}

// One cut of each of several sweeps.
Cuts compared_cuts(const std::vector<PlottedSweep>& sweeps, const CutChoice& choice) {
  Cuts compared;
  bool at_one_angle = true;
  std::string axis;
  for (const PlottedSweep& sweep : sweeps) {
    Cuts cuts = chosen_cuts(sweep, choice);
    require_one_cut(sweep, cuts);
    if (!compared.cuts.empty() && cuts.angle != compared.angle)
      throw InputError(
          Place{sweep.input},
          fmt::format("its cut is against {}, expected {} as of {}: choose cuts by --elevation or --azimuth", cuts.axis,
                      compared.axis, sweeps.front().input));
    at_one_angle = at_one_angle && (axis.empty() || axis == axis_title(cuts));
    axis = axis_title(cuts);
    compared.axis = cuts.axis;
    compared.angle = cuts.angle;
    compared.cuts.push_back(cuts.cuts.front());
    compared.cuts.back().curve.label = sweep.label;
  }
  if (at_one_angle) compared.axis = axis;
  return compared;
}

Cuts cuts_to_draw(const std::vector<PlottedSweep>& sweeps, const CutChoice& choice, const Common& common) {
  if (sweeps.size() > 1) return compared_cuts(sweeps, choice);
  Cuts cuts = chosen_cuts(sweeps.front(), choice);
  cuts.axis = axis_title(cuts);
  if (cuts.cuts.size() > most_curves && !common.quiet)
    fmt::print(stderr, "lrcs: warning: the plot shows the first {} of {} cuts\n", most_curves, cuts.cuts.size());
  return cuts;
}

void draw_cuts(Canvas& canvas, const PlotOptions& options, const std::vector<PlottedSweep>& sweeps,
               const Common& common) {
  const Cuts cuts = cuts_to_draw(sweeps, cut_choice(options), common);
  const PlotText text{plot_title(options, sweeps), cuts.axis, cuts.angle, checked_floor(options, sweeps)};
  if (options.kind == "polar")
    draw_polar_plot(canvas, cuts.curves(most_curves), text);
  else
    draw_sweep_plot(canvas, cuts.curves(most_curves), text);
}

void draw_map(Canvas& canvas, const PlotOptions& options, const std::vector<PlottedSweep>& sweeps) {
  const auto map = direction_map(sweeps.front().rows);
  if (!map)
    throw InputError(
        Place{sweeps.front().input},
        fmt::format("--kind {}: expected a sweep over a grid of two or more azimuths and elevations", options.kind));
  const MapText text{plot_title(options, sweeps), checked_floor(options, sweeps)};
  if (options.kind == "map") {
    draw_map_plot(canvas, *map, text);
    return;
  }
  const std::string from = options.from.empty() ? "30,25" : options.from;
  draw_sphere_plot(canvas, *map, angle_pair_from_words(from, "--from"), text);
}

void draw_parts(Canvas& canvas, const PlotOptions& options, const std::vector<PlottedSweep>& sweeps,
                const Common& common) {
  const PlottedSweep& sweep = sweeps.front();
  if (!std::filesystem::is_directory(sweep.input))
    throw InputError(Place{sweep.input}, "--kind parts: expected a folder that lrcs sweep wrote: its target is read");
  const Cuts cuts = chosen_cuts(sweep, cut_choice(options));
  require_one_cut(sweep, cuts);
  const ViewedCut& cut = cuts.cuts.front();
  if (cut.rows.size() < 2)
    throw InputError(Place{sweep.input}, "--kind parts: expected a cut of two directions or more, found one");
  const PastRun run = read_past_run(sweep.input);
  LayerStack stack;
  {
    ProgressBar bar(cut.rows.size(), "directions", !common.quiet);
    stack = part_stack(run, cut, common.threads, [&](std::size_t done) { bar.update(done); });
  }
  const std::string note = run.scene.relative_accuracy ? "Computed exactly; the sweep was sampled" : "";
  draw_stacked_plot(canvas, stack, {plot_title(options, sweeps), note, axis_title(cuts)});
}

void plot(const PlotOptions& options, const Common& common) {
  require_kind(options.kind);
  require_fitting_flags(options);
  Canvas canvas = canvas_for(options);
  require_folder_of(options.output, "--output");
  std::vector<PlottedSweep> sweeps;
  for (const std::string& input : options.inputs) sweeps.push_back(read_plotted_sweep(input));
  tell_apart(sweeps);
  for (std::size_t i = 0; i < options.labels.size(); ++i) sweeps[i].label = options.labels[i];
  if (options.kind == "parts")
    draw_parts(canvas, options, sweeps, common);
  else if (options.kind == "map" || options.kind == "sphere")
    draw_map(canvas, options, sweeps);
  else
    draw_cuts(canvas, options, sweeps, common);
  write_plot(options.output, canvas);
}

}  // namespace

void add_plot_command(CLI::App& app, Common& common) {
  const auto options = std::make_shared<PlotOptions>();
  CLI::App* verb = app.add_subcommand("plot", "Plots of sweeps that are done, PNG or SVG");
  verb->add_option("inputs", options->inputs,
                   "Folders that lrcs sweep wrote, or sweep.csv files; two or more: compared")
      ->required();
  verb->add_option("-o,--output", options->output, "The plot, .png or .svg (default plot.png)");
  verb->add_option("--kind", options->kind,
                   "cut: dBsm against the angle; polar: the same about a centre; map, sphere: dBsm over both angles; "
                   "parts: m^2 against the angle, part by part (default cut)");
  verb->add_option("--elevation", options->elevation, "The cut against azimuth at this elevation [deg]");
  verb->add_option("--azimuth", options->azimuth, "The cut against elevation at this azimuth [deg]");
  verb->add_option("--label", options->labels, "Name of a sweep in the legend, one for each, in order; repeated")
      ->allow_extra_args(false);
  verb->add_option("--title", options->title, "Above the plot (default: what it shows, and of which target)");
  verb->add_option("--floor", options->floor, "Lowest dBsm drawn (default: about 60 dB below the highest)");
  verb->add_option("--from", options->from, "Where a sphere is seen from: AZIMUTH,ELEVATION [deg] (default 30,25)");
  verb->add_option("--size", options->size, "WIDTHxHEIGHT [pixel] (default 1600x1000; polar 1200x1200)");
  add_common_flags(*verb, common);
  verb->callback([options, &common] { plot(*options, common); });
}

}  // namespace lrcs
