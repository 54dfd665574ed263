#include "bench/fit_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "bench/median.h"

namespace lrcs {
namespace {

std::vector<FitRun> all_runs(const std::vector<FitComparison>& comparisons) {
  std::vector<FitRun> runs;
  for (const FitComparison& c : comparisons) runs.insert(runs.end(), c.runs.begin(), c.runs.end());
  return runs;
}

std::vector<std::string> methods_of(const std::vector<FitRun>& runs) {
  std::vector<std::string> names;
  for (const FitRun& r : runs)
    if (std::ranges::count(names, r.method) == 0) names.push_back(r.method);
  return names;
}

template <class Value>
double median_of(const std::vector<FitRun>& runs, const Value& value) {
  std::vector<double> values;
  values.reserve(runs.size());
  for (const FitRun& r : runs) values.push_back(static_cast<double>(value(r)));
  return median(values);
}

template <class Squares>
double share(const std::vector<FitRun>& runs, const Squares& squares) {
  if (runs.empty()) return 0.0;
  const auto count = std::ranges::count_if(runs, [&](const FitRun& r) { return is_success(squares(r), r.best); });
  return static_cast<double>(count) / static_cast<double>(runs.size());
}

FitSummary summary_of(const std::string& method, const std::vector<FitRun>& all, const std::vector<double>& noises) {
  std::vector<FitRun> runs;
  std::ranges::copy_if(all, std::back_inserter(runs), [&](const FitRun& r) { return r.method == method; });
  const auto squares = [](const FitRun& r) { return r.squares; };
  FitSummary s;
  s.method = method;
  s.seconds = median_of(runs, [](const FitRun& r) { return r.seconds; });
  s.evaluations = median_of(runs, [](const FitRun& r) { return r.evaluations; });
  s.success = share(runs, squares);
  s.success_polished = share(runs, [](const FitRun& r) { return r.polished; });
  for (const double noise : noises) {
    std::vector<FitRun> at;
    std::ranges::copy_if(runs, std::back_inserter(at), [&](const FitRun& r) { return r.noise == noise; });
    s.success_at.push_back(share(at, squares));
  }
  for (const FitRun& r : runs)
    if (!is_success(r.best, 0.0)) s.worst_ratio = std::max(s.worst_ratio, r.squares / r.best);
  return s;
}

std::string head(const std::vector<double>& noises) {
  std::string text = fmt::format("{:22}{:>9}{:>13}{:>11}", "method", "time [s]", "evaluations", "success");
  for (const double noise : noises) text += fmt::format("{:>9}", fmt::format("at {:g} %", 100.0 * noise));
  return text + fmt::format("{:>14}{:>16}\n", "worst ratio", "then polished");
}

std::string line(const FitSummary& s) {
  std::string text =
      fmt::format("{:22}{:9.3f}{:13.0f}{:9.1f} %", s.method, s.seconds, s.evaluations, 100.0 * s.success);
  for (const double share : s.success_at) text += fmt::format("{:9.1f}", 100.0 * share);
  return text + fmt::format("{:14.6g}{:14.1f} %\n", s.worst_ratio, 100.0 * s.success_polished);
}

std::string below(const std::vector<FitComparison>& comparisons) {
  const auto in_box = std::ranges::count_if(comparisons, [](const FitComparison& c) { return c.box_holds_best; });
  const auto truth = std::ranges::count_if(comparisons, [](const FitComparison& c) { return c.truth_is_best; });
  return fmt::format(
      "the best known lies in the box in {} of {} sets of data; a descent from the true parameters ends there in {}\n",
      in_box, comparisons.size(), truth);
}

}  // namespace

std::vector<FitSummary> fit_summaries(const std::vector<FitComparison>& comparisons,
                                      const std::vector<double>& noises) {
  const std::vector<FitRun> runs = all_runs(comparisons);
  std::vector<FitSummary> all;
  for (const std::string& method : methods_of(runs)) all.push_back(summary_of(method, runs, noises));
  return all;
}

std::string fit_table_text(const std::string& form, const std::vector<FitComparison>& comparisons,
                           const std::vector<double>& noises) {
  std::string text = fmt::format("\n{}: {} sets of data\n", form, comparisons.size()) + head(noises);
  for (const FitSummary& s : fit_summaries(comparisons, noises)) text += line(s);
  return text + below(comparisons);
}

std::vector<std::string> missed_bars(const std::vector<FitSummary>& summaries) {
  std::vector<std::string> missed;
  for (const FitSummary& s : summaries) {
    if (!s.method.starts_with("lrcs")) continue;
    if (s.success < 1.0) missed.push_back(fmt::format("{}: success {:.1f} %, not 100 %", s.method, 100.0 * s.success));
    if (s.seconds > 0.5) missed.push_back(fmt::format("{}: {:.3f} s, more than 0.5 s", s.method, s.seconds));
  }
  return missed;
}

}  // namespace lrcs
