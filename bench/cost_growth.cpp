#include "bench/cost_growth.h"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <iterator>
#include <map>

namespace lrcs {

double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y) {
  assert(x.size() == y.size() && x.size() >= 2);
  const auto count = static_cast<double>(x.size());
  double mean_x = 0.0, mean_y = 0.0, xx = 0.0, xy = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    mean_x += std::log(x[k]) / count;
    mean_y += std::log(y[k]) / count;
  }
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double dx = std::log(x[k]) - mean_x;
    xx += dx * dx;
    xy += dx * (std::log(y[k]) - mean_y);
  }
  return xy / xx;
}

std::string cost_growth_text(const std::vector<Summary>& of_like_targets) {
  std::vector<std::string> order;
  std::map<std::string, std::vector<Summary>> of_method;
  for (const Summary& s : of_like_targets) {
    auto& same = of_method[s.method];
    if (same.empty()) order.push_back(s.method);
    same.push_back(s);
  }
  std::string lines;
  for (const std::string& method : order) {
    std::vector<double> facets, seconds;
    std::string times;
    for (const Summary& s : of_method.at(method)) {
      facets.push_back(static_cast<double>(s.facets));
      seconds.push_back(s.seconds);
      fmt::format_to(std::back_inserter(times), "{:11.2f} ({})", 1e3 * s.seconds, s.facets);
    }
    if (facets.size() < 2) continue;
    fmt::format_to(std::back_inserter(lines), "  {:26}p = {:5.2f}{}\n", method, fitted_exponent(facets, seconds),
                   times);
  }
  return lines.empty() ? "" : "\ncost growth: time ~ facets^p, and time [ms] at each number of facets\n" + lines;
}

}  // namespace lrcs
