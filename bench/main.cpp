// lrcs_bench: what the exact method costs, and what sampling costs and misses. See about() or --help.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/input_error.h"
#include "bench/cost_growth.h"
#include "bench/equal_error.h"
#include "bench/honest_bounds.h"
#include "bench/measurement.h"
#include "bench/summary.h"
#include "bench/sweep_speed.h"
#include "bench/targets.h"
#include "bench/work_precision_plot.h"
#include "bench/z_buffer.h"

namespace lrcs {
namespace {

constexpr int done = 0, found_faults = 1, could_not_finish = 1, wrong_input = 2;

struct Options {
  std::vector<std::string> targets;  // empty: those of the run
  std::size_t directions = 0;        // 0: as many as the run takes
  int runs = 5;
  double longest_run = 20.0;  // [s]
  std::filesystem::path out = "results/bench";
  bool is_short = false;
  bool only_sweeps = false;
};

std::string about() {
  return fmt::format(
      "Error AND time of ways to find what is seen of a target, monostatic, in one process, on one thread:\n"
      "exact; Embree with 1, 4, 16, 64, 256 stratified rays from every front facet; an Embree ray grid of 32^2 to\n"
      "4096^2; an OpenGL z-buffer of the same sizes (software OpenGL, one thread, left out where there is none);\n"
      "accuracy: {{relative: r}} of 1e-2, 1e-3, 1e-4, and its time beside the others' at equal error; and\n"
      "whether its bounds hold, also bistatic and at round angles.\n"
      "\n"
      "Time: from a direction to the seen part of every facet. What is built once a target is said apart, with the\n"
      "memory by which this process grows at its peak. Methods take turns, run by run, in every direction.\n"
      "Error: relative to the exact method, of sigma (Lambert, and metal-skin-5p) and of the projected seen area, "
      "over\n"
      "the facets' front sides. Then, unless --targets: growth of time with facets, thread scaling, and the speed of\n"
      "a convex sweep beside the machine's copy bandwidth.\n"
      "\n"
      "In the folder of --out: measurements.csv (every run) and work-precision-TARGET.png.\n"
      "Known targets: {}.\n"
      "Exit status: 0; 1: --short found an error that sampling does not explain, or the run could not finish; 2: "
      "wrong\n"
      "input.",
      fmt::join(known_targets(), ", "));
}

void print(const std::string& text) {
  fmt::print("{}", text);
  std::fflush(stdout);
}

void print_head(const std::string& target, std::size_t facets, const Methods& methods) {
  print(fmt::format("\n{}: {} facets\n", target, facets));
  for (const Building& b : methods.built)
    print(fmt::format("  built once: {:10}{:8.0f} ms{:10.1f} MB at its peak,{:7.0f} bytes a facet\n", b.what,
                      1e3 * b.seconds, 1e-6 * b.bytes, b.bytes / static_cast<double>(facets)));
}

class Bench {
 public:
  explicit Bench(const Options& options) : options_(options) {
    std::filesystem::create_directories(options.out);
    std::string why;
    display_ = open_z_buffer_display(&why);
    if (!display_) print(fmt::format("no z-buffer: OpenGL cannot draw here: {}\n", why));
  }

  void measure_targets() {
    for (const std::string& target : targets()) measure_target(target);
    print(cost_growth_text(spheres_));
  }

  void measure_sweeps() const {
    print("\n");
    const bool s = options_.is_short;
    print(thread_scaling(s ? 20 : 100, s ? 1 : 3));
    print(convex_sweep_speed(s ? 6 : 8, s ? 720 : 1440, s ? 1 : 3));
  }

  // Whether all methods agree as far as they should; prints where not.
  [[nodiscard]] bool agree() const {
    const auto lines = faults(measured_);
    if (!lines.empty())
      print(fmt::format("\nerrors that sampling does not explain:\n  {}\n", fmt::join(lines, "\n  ")));
    return lines.empty();
  }

 private:
  [[nodiscard]] const std::vector<std::string>& targets() const {
    if (!options_.targets.empty()) return options_.targets;
    return options_.is_short ? short_targets() : known_targets();
  }

  void measure_target(const std::string& target) {
    const FacetMesh mesh = target_mesh(target);
    const Fineness coarse{{1, 2, 4}, {256, 1024}};
    const Methods methods = methods_for(mesh, options_.is_short ? coarse : Fineness{}, display_.get());
    const std::string name = short_name(target);
    print_head(name, mesh.size(), methods);
    const std::size_t usual = options_.is_short ? 2 : 7;
    const Plan plan{.directions = seeded_directions(options_.directions > 0 ? options_.directions : usual),
                    .runs = options_.runs,
                    .longest_run = options_.longest_run};
    const auto rows = measure(name, mesh.size(), methods, plan);
    const auto summary = summaries(rows);
    print(table_text(summary));
    print(equal_error_text(rows));
    print(honest_bounds_text(mesh, options_.is_short));
    draw_work_precision(options_.out / ("work-precision-" + name + ".png"), summary, plan.directions.size());
    if (std::ranges::count(bumpy_spheres(), target) > 0)
      spheres_.insert(spheres_.end(), summary.begin(), summary.end());
    measured_.insert(measured_.end(), rows.begin(), rows.end());
    write_csv(options_.out / "measurements.csv", measured_);
  }

  const Options& options_;
  std::unique_ptr<PrivateDisplay> display_;
  std::vector<Measurement> measured_;
  std::vector<Summary> spheres_;
};

int run(int argc, char** argv) {
  Options options;
  CLI::App app(about(), "lrcs_bench");
  app.add_flag("--short", options.is_short, "A minute: small targets, few directions, coarse sampling; checks errors");
  app.add_option("--targets", options.targets, "Known targets or mesh files, with commas; only these, no sweeps")
      ->delimiter(',');
  app.add_flag("--sweeps", options.only_sweeps, "Thread scaling and convex sweep only, or beside --targets");
  app.add_option("--directions", options.directions, "Seeded directions a target (default 7; 2 with --short)")
      ->check(CLI::Range(1, 1000));
  app.add_option("--runs", options.runs, "Runs of a method in a direction (default 5)")->check(CLI::Range(1, 100));
  app.add_option("--longest-s", options.longest_run,
                 "Leave out methods that would run longer than this [s] (default 20)");
  app.add_option("-o,--out", options.out, "Folder for CSV and pictures (default results/bench)");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& stop) {
    return app.exit(stop) == 0 ? done : wrong_input;
  }
  Bench bench(options);
  if (!options.only_sweeps || !options.targets.empty()) bench.measure_targets();
  if (options.only_sweeps || options.targets.empty()) bench.measure_sweeps();
  return !bench.agree() && options.is_short ? found_faults : done;
}

}  // namespace
}  // namespace lrcs

int main(int argc, char** argv) try { return lrcs::run(argc, argv); } catch (const lrcs::InputError& wrong) {
  std::fprintf(stderr, "lrcs_bench: %s\n", wrong.what());
  return lrcs::wrong_input;
} catch (const std::exception& failed) {
  std::fprintf(stderr, "lrcs_bench: %s\n", failed.what());
  return lrcs::could_not_finish;
}
