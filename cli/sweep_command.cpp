#include <fmt/chrono.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <memory>
#include <thread>

#include "cli/commands.h"
#include "cli/progress_bar.h"
#include "cli/scene_from_flags.h"
#include "cli/sweep_results.h"
#include "lrcs/sweep_csv.h"

namespace lrcs {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

bool is_scene_file(const std::filesystem::path& file) {
  return file.extension() == ".yaml" || file.extension() == ".yml";
}

Scene scene_of(const std::string& input, const SceneFlags& flags) {
  if (!is_scene_file(input)) return scene_from_flags(input, flags);
  const std::string flag = flags.first_given();
  if (!flag.empty()) throw InputError(fmt::format("{}: expected no such flag beside the scene file {}", flag, input));
  return read_scene(input);
}

void say_repairs(const LoadedTarget& loaded) {
  const RepairCounts& r = loaded.repaired;
  if (r.welded_vertices + r.degenerate + r.duplicate + r.flipped == 0) return;
  fmt::print(
      stderr,
      "lrcs: repaired: {} repeated vertices welded, {} degenerate and {} duplicate facets dropped, {} facets turned "
      "outward\n",
      r.welded_vertices, r.degenerate, r.duplicate, r.flipped);
}

void say_plan(const Scene& scene, const LoadedTarget& loaded, const RunFacts& facts) {
  fmt::print(stderr, "lrcs: {} facets in {} parts, {} directions, {} threads\n", loaded.target.mesh.size(),
             loaded.target.mesh.part.names.size(), scene.directions.size(), facts.threads);
}

void say_result(const std::vector<SweepRow>& rows, double seconds, const std::filesystem::path& folder) {
  const auto [low, high] = std::minmax_element(
      rows.begin(), rows.end(), [](const SweepRow& a, const SweepRow& b) { return a.sigma.value < b.sigma.value; });
  fmt::print(stderr,
             "lrcs: {} directions in {:.2f} s: sigma {:.6g} to {:.6g} m^2 ({:.2f} to {:.2f} dBsm); results in {}\n",
             rows.size(), seconds, low->sigma.value, high->sigma.value, dbsm(low->sigma.value), dbsm(high->sigma.value),
             folder.string());
}

void run(const Scene& scene, const std::filesystem::path& folder, bool with_hdf5, const Common& common) {
  RunFacts facts;
  facts.command = common.command;
  facts.started_utc = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  facts.threads = common.threads != 0 ? common.threads : std::max(1U, std::thread::hardware_concurrency());
  facts.warnings = material_warnings(scene);

  (void)facet_rows(scene);  // a large target is not read in vain
  auto start = Clock::now();
  const LoadedTarget loaded = load_target(scene);
  facts.read_seconds = seconds_since(start);
  facts.warnings.insert(facts.warnings.end(), loaded.warnings.begin(), loaded.warnings.end());
  SweepResults results(folder, scene, loaded, with_hdf5);
  if (!common.quiet) say_repairs(loaded);
  if (common.verbose && !common.quiet) say_plan(scene, loaded, facts);
  const std::vector<Aspect> aspects = aspects_of(scene.directions, scene.receiver);
  start = Clock::now();
  std::vector<SweepRow> rows;
  {
    ProgressBar bar(aspects.size(), "directions", !common.quiet);
    rows = run_sweep(
        loaded.target, aspects, facts.threads,
        {[&](std::size_t done) { bar.update(done); }, [&](std::size_t row) { return results.wants_facets(row); },
         [&](std::size_t row, const SweepRow& result, const CrossSection& section) {
           results.write_facets(row, result, section);
         }},
        &facts.skipped, scene.relative_accuracy, &facts.methods);
  }
  facts.sweep_seconds = seconds_since(start);
  results.write_table(rows);
  results.draw(rows, facts.warnings);
  for (const auto& warning : facts.warnings)
    if (!common.quiet) fmt::print(stderr, "lrcs: warning: {}\n", warning);
  results.write_manifest(facts);
  if (!common.quiet) say_result(rows, facts.sweep_seconds, folder);
}

}  // namespace

void add_sweep_command(CLI::App& app, Common& common) {
  struct Options {
    std::string input, folder;
    bool hdf5 = false;
    SceneFlags flags;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand("sweep", "LRCS over the directions of a sweep");
  verb->add_option("input", options->input, "SCENE.yaml, or a target's mesh and the flags below")->required();
  verb->add_option("-o,--output", options->folder, "Folder for the results (default: <input>-lrcs)");
  verb->add_flag("--hdf5", options->hdf5, "Write sweep.h5, too: HDF5 with dimension scales and units");
  options->flags.add_to(*verb);
  add_common_flags(*verb, common);
  verb->callback([options, &common] {
    const Scene scene = scene_of(options->input, options->flags);
    const std::string stem = std::filesystem::path(options->input).stem().string();
    run(scene, options->folder.empty() ? stem + "-lrcs" : options->folder, options->hdf5, common);
  });
}

}  // namespace lrcs
