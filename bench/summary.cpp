#include "bench/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <map>

#include "bench/median.h"

namespace lrcs {
namespace {

using Key = std::pair<double, double>;  // of a direction [deg]

struct Runs {
  std::map<Key, std::vector<double>> seconds;
  std::map<Key, SeenSums> error;
  std::size_t facets = 0;
  std::string family, mark;
};

struct Grouped {
  std::vector<std::string> order;
  std::map<std::string, Runs> of_method;
};

Grouped grouped(const std::vector<Measurement>& measurements) {
  Grouped groups;
  for (const Measurement& m : measurements) {
    const auto [at, is_new] = groups.of_method.try_emplace(m.method);
    if (is_new) groups.order.push_back(m.method);
    const Key key{m.direction.azimuth_deg, m.direction.elevation_deg};
    at->second.seconds[key].push_back(m.seconds);
    at->second.error[key] = m.error;
    at->second.facets = m.facets;
    at->second.family = m.family;
    at->second.mark = m.mark;
  }
  return groups;
}

template <class Pick>
SeenSums one_by_one(const Runs& runs, const Pick& pick) {
  std::vector<double> lambert, wu, area;
  for (const auto& [key, error] : runs.error) {
    lambert.push_back(error.sigma_lambert);
    wu.push_back(error.sigma_wu);
    area.push_back(error.seen_area);
  }
  return {pick(lambert), pick(wu), pick(area)};
}

std::string error_text(double error) {
  return std::isnan(error) ? fmt::format("{:>10}", "-") : fmt::format("{:10.1e}", error);
}

}  // namespace

double root_mean_square(const std::vector<double>& values) {
  assert(!values.empty());
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

std::vector<Summary> summaries(const std::vector<Measurement>& of_target) {
  const Grouped groups = grouped(of_target);
  const auto reference = groups.of_method.find(one_ray);
  std::vector<Summary> result;
  for (const std::string& method : groups.order) {
    const Runs& runs = groups.of_method.at(method);
    std::vector<double> seconds, least, ratios;
    for (const auto& [key, times] : runs.seconds) {
      seconds.push_back(median(times));
      least.push_back(*std::min_element(times.begin(), times.end()));
      if (reference == groups.of_method.end()) continue;
      const auto same = reference->second.seconds.find(key);
      if (same != reference->second.seconds.end()) ratios.push_back(seconds.back() / median(same->second));
    }
    const auto largest = [](const std::vector<double>& errors) {
      return *std::max_element(errors.begin(), errors.end());
    };
    result.push_back({of_target.front().target, runs.facets, runs.family, method, runs.mark, median(seconds),
                      median(least), ratios.empty() ? 0.0 : median(ratios), one_by_one(runs, root_mean_square),
                      one_by_one(runs, largest)});
  }
  return result;
}

std::string table_text(const std::vector<Summary>& of_target) {
  std::string text =
      fmt::format("  {:26}{:>11}{:>11}   {:29} {}\n", "", "", "time over", "error, root mean square", "largest error");
  fmt::format_to(std::back_inserter(text), "  {:26}{:>11}{:>11}", "method", "time [ms]", "one ray");
  for (int k = 0; k < 2; ++k) fmt::format_to(std::back_inserter(text), "{:>10}{:>10}{:>10}", "Lambert", "Wu", "area");
  text += '\n';
  for (const Summary& s : of_target) {
    fmt::format_to(std::back_inserter(text), "  {:26}{:11.2f}{:11.2f}", s.method, 1e3 * s.seconds, s.over_one_ray);
    for (const SeenSums* e : {&s.error, &s.largest_error})
      for (const double error : {e->sigma_lambert, e->sigma_wu, e->seen_area}) text += error_text(error);
    text += '\n';
  }
  return text;
}

}  // namespace lrcs
