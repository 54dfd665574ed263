#include "bench/equal_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

#include "bench/median.h"
#include "bench/method.h"
#include "bench/summary.h"

namespace lrcs {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

struct Baseline {
  std::string family;
  double seconds = never;
};

Baseline cheapest(double error, const std::vector<Summary>& of_target) {
  std::map<std::string, std::vector<WorkPrecision>> curves;
  for (const Summary& s : of_target)
    if (is_baseline(s.family) && s.error.sigma_wu > 0.0)
      curves[s.family].push_back({s.error.sigma_wu, s.least_seconds});
  Baseline best;
  for (const auto& [family, curve] : curves)
    if (const double seconds = seconds_at(error, curve); seconds < best.seconds) best = {family, seconds};
  return best;
}

// Bounds over errors, of each direction once; exact ones have none.
struct Bounds {
  std::vector<double> over_error;
  std::vector<std::string> passed;

  void add(const Measurement& m) {
    if (m.run > 0 || m.bound == 0.0) return;
    over_error.push_back(m.bound / m.error.sigma_wu);
    if (over_error.back() < 1.0)
      passed.push_back(fmt::format("  ERROR PASSES ITS BOUND: {}, azimuth {:.1f} deg, elevation {:.1f} deg\n", m.method,
                                   m.direction.azimuth_deg, m.direction.elevation_deg));
  }
};

std::string line(const Summary& s, const std::vector<Summary>& of_target, const Bounds& bounds) {
  std::string text = fmt::format("  {:16}{:10.1e}{:10.1e}", s.method, s.error.sigma_wu, s.largest_error.sigma_wu);
  if (bounds.over_error.empty()) return text + "     exact\n";
  const auto& over = bounds.over_error;
  fmt::format_to(std::back_inserter(text), "{:10.1f}{:10.1f}", *std::min_element(over.begin(), over.end()),
                 median(over));
  const Baseline best = cheapest(s.error.sigma_wu, of_target);
  if (best.seconds == never) return text + "          no baseline is as good\n";
  fmt::format_to(std::back_inserter(text), "{:10.2f}  {}\n", s.least_seconds / best.seconds, best.family);
  for (const std::string& passed : bounds.passed) text += passed;
  return text;
}

}  // namespace

double seconds_at(double error, const std::vector<WorkPrecision>& curve) {
  double least = never;
  if (!curve.empty() && error >= curve.front().error) least = curve.front().seconds;
  for (std::size_t k = 0; k + 1 < curve.size(); ++k) {
    const WorkPrecision &a = curve[k], &b = curve[k + 1];
    if ((a.error - error) * (b.error - error) > 0.0 || a.error == b.error) continue;
    const double part = std::log(error / a.error) / std::log(b.error / a.error);
    least = std::min(least, a.seconds * std::pow(b.seconds / a.seconds, part));
  }
  return least;
}

std::string equal_error_text(const std::vector<Measurement>& of_target) {
  const auto summary = summaries(of_target);
  std::string text = fmt::format("  {:16}{:>10}{:>10}{:>10}{:>10}{:>10}  {}\n", "sigma, Wu", "error", "largest",
                                 "bound/err", "median", "time", "over the cheapest baseline at equal error");
  for (const Summary& s : summary) {
    if (s.family != relative_family) continue;
    Bounds bounds;
    for (const Measurement& m : of_target)
      if (m.method == s.method) bounds.add(m);
    text += line(s, summary, bounds);
  }
  return text;
}

}  // namespace lrcs
