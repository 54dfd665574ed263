// lrcs_fit_bench: how often, and how soon, ways to fit a BRDF find the best parameters. See about() or --help.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "bench/fit_comparison.h"
#include "bench/fit_coverage.h"
#include "bench/fit_data.h"
#include "bench/fit_methods.h"
#include "bench/fit_table.h"
#include "bench/machine_facts.h"
#include "bench/stopwatch.h"

namespace lrcs {
namespace {

constexpr int done = 0, missed = 1, could_not_finish = 1, wrong_input = 2;

struct Options {
  std::vector<std::string> forms{"nine_parameter", "five_parameter"};
  std::vector<double> noises{0.0, 0.01, 0.03};  // [1]
  int first_seed = 1;
  int seeds = 20;
  int reference = 200;
  FitBudget budget;
  double longest = 1e9;  // [s]
  int coverage = 0;
  bool only_lrcs = false;
  bool is_short = false;
};

constexpr auto about =
    "Success AND time of ways to fit Wu's model, in one process, on the same data, on one thread.\n"
    "\n"
    "Data: the four published materials, in plane, theta_i 0, 10, 30, 50 deg, theta_r -80 to 80 deg every 4 deg, with\n"
    "noise of 0, 1, 3 % of the value. Methods: lrcs search; lrcs fit (with all it does besides); genetic simulated\n"
    "annealing over all parameters without polish; pagmo's simulated annealing, self-adaptive differential evolution\n"
    "and CMA-ES; Ceres from many places; one descent (Levenberg-Marquardt, linear parameters solved for first).\n"
    "Those without derivatives look over all parameters within the search range; kb, kd up to twice the largest f "
    "cos.\n"
    "\n"
    "Success: the sum of squares is at most 1.001 times the best known, or E at most 1e-10 %. Best known: the least\n"
    "of all methods, of --reference descents from anywhere, and of one from the true parameters. Then polished: "
    "success\n"
    "after one descent from where a method ended, whose time is not counted. Ratio: sum of squares over the best\n"
    "known, where that is not exact. Time: of the processor. Evaluations: of residuals, or of residuals with\n"
    "derivatives. Both: medians.\n"
    "Exit status: 0; 1: --short and lrcs misses a success of 100 % or a median time of 0.5 s; 2: wrong input.";

void print(const std::string& text) {
  fmt::print("{}", text);
  std::fflush(stdout);
}

// Whether lrcs passed its bars.
bool measure(const std::string& form, const Options& options) {
  std::vector<FitComparison> comparisons;
  auto methods = fit_methods(options.budget);
  if (options.only_lrcs) std::erase_if(methods, [](const FitMethod& m) { return !m.name.starts_with("lrcs"); });
  const Stopwatch watch;
  const int last = options.first_seed + options.seeds - 1;
  for (int seed = options.first_seed; seed <= last && watch.seconds() < options.longest; ++seed)
    for (const FitData& data : all_fit_data(options.noises, static_cast<std::uint64_t>(seed)))
      comparisons.push_back(compare_fits(methods, form, data, options.reference));
  print(fit_table_text(form, comparisons, options.noises));
  const auto misses = missed_bars(fit_summaries(comparisons, options.noises));
  print(misses.empty() ? "bars passed: lrcs 100 % success, median time at most 0.5 s\n"
                       : fmt::format("bars missed: {}\n", fmt::join(misses, "; ")));
  return misses.empty();
}

void shorten(Options& options) {
  options.noises = {0.0, 0.03};
  options.seeds = 1;
  options.reference = 40;
  options.budget = {.evaluations = 4000, .starts = 10};
}

int run(int argc, char** argv) {
  Options options;
  CLI::App app(about, "lrcs_fit_bench");
  app.add_flag("--short", options.is_short, "Half a minute: one seed, little of the others; checks lrcs");
  const auto not_short = [&](CLI::Option* option) { option->excludes(app.get_option("--short")); };
  app.add_option("--forms", options.forms, "nine_parameter, five_parameter or both, with a comma")
      ->delimiter(',')
      ->check(CLI::IsMember({"nine_parameter", "five_parameter"}));
  not_short(
      app.add_option("--seeds", options.seeds, "Seeds a material and noise (default 20)")->check(CLI::Range(1, 1000)));
  not_short(app.add_option("--first-seed", options.first_seed, "So that a long run may be made in pieces (default 1)")
                ->check(CLI::Range(1, 1000000)));
  not_short(app.add_option("--noises", options.noises, "Standard deviations over the value (default 0,0.01,0.03)")
                ->delimiter(',')
                ->check(CLI::Range(0.0, 1.0)));
  not_short(app.add_option("--reference", options.reference, "Descents from anywhere a set of data (default 200)")
                ->check(CLI::Range(1, 100000)));
  not_short(
      app.add_option("--evaluations", options.budget.evaluations, "Of a method without derivatives (default 40000)")
          ->check(CLI::Range(1000, 10000000)));
  not_short(app.add_option("--starts", options.budget.starts, "Of Ceres (default 100)")->check(CLI::Range(1, 100000)));
  not_short(
      app.add_option("--longest-s", options.longest, "No further seed for a form after so long [s] (default: all)"));
  not_short(app.add_flag("--only-lrcs", options.only_lrcs, "None of the other methods, but --reference descents"));
  not_short(app.add_option("--coverage", options.coverage,
                           "Instead: how often intervals hold the truth, in so many repetitions a case")
                ->check(CLI::Range(1, 100000)));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& stop) {
    return app.exit(stop) == 0 ? done : wrong_input;
  }
  if (options.is_short) shorten(options);
  print(machine_facts());
  if (options.coverage > 0) {
    print_coverage(options.forms, options.noises, options.coverage);
    return done;
  }
  print(fmt::format(
      "seeds: at most {} from {} on, descents from anywhere {}, evaluations without derivatives {}, Ceres starts {}\n",
      options.seeds, options.first_seed, options.reference, options.budget.evaluations, options.budget.starts));
  bool passed = true;
  for (const std::string& form : options.forms) passed = measure(form, options) && passed;
  return options.is_short && !passed ? missed : done;
}

}  // namespace
}  // namespace lrcs

int main(int argc, char** argv) try { return lrcs::run(argc, argv); } catch (const std::exception& failed) {
  std::fprintf(stderr, "lrcs_fit_bench: %s\n", failed.what());
  return lrcs::could_not_finish;
}
