#include "view/decibel_cut.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "view/ticks.h"

namespace lrcs {
namespace {

constexpr double turn = 360.0;    // [deg]
constexpr double deepest = 60.0;  // drawn below the highest point [dB]

void require_valid(const Curve& curve) {
  const auto refuse = [&](const char* what) { throw std::invalid_argument("curve '" + curve.label + "': " + what); };
  if (curve.angle_deg.size() != curve.sigma_m2.size()) refuse("as many angles as values are needed");
  const auto finite = [](double value) { return std::isfinite(value); };
  if (!std::all_of(curve.angle_deg.begin(), curve.angle_deg.end(), finite)) refuse("an angle is not finite");
  const auto allowed = [](double sigma) { return std::isfinite(sigma) && sigma >= 0.0; };
  if (!std::all_of(curve.sigma_m2.begin(), curve.sigma_m2.end(), allowed)) refuse("a LRCS is not finite and >= 0");
  if (!curve.bound_m2.empty() && curve.bound_m2.size() != curve.sigma_m2.size())
    refuse("as many bounds as values are needed, or none");
  if (!std::all_of(curve.bound_m2.begin(), curve.bound_m2.end(), allowed)) refuse("a bound is not finite and >= 0");
}

double decibels(double sigma_m2) {
  return 10.0 * std::log10(sigma_m2);
}

bool lower_angle(const CutPoint& a, const CutPoint& b) {
  return a.angle_deg < b.angle_deg;
}

bool runs_one_way(const std::vector<CutPoint>& cut) {
  return std::is_sorted(cut.begin(), cut.end(), lower_angle) || std::is_sorted(cut.rbegin(), cut.rend(), lower_angle);
}

std::vector<CutPoint> with_turns_added(std::vector<CutPoint> cut) {
  for (std::size_t i = 1; i < cut.size(); ++i) {
    const double jump = cut[i].angle_deg - cut[i - 1].angle_deg;
    cut[i].angle_deg -= turn * std::round(jump / turn);
  }
  return cut;
}

std::vector<CutPoint> in_order(const std::vector<CutPoint>& cut) {
  if (runs_one_way(cut)) return cut;
  std::vector<CutPoint> unwrapped = with_turns_added(cut);
  if (runs_one_way(unwrapped)) return unwrapped;
  std::vector<CutPoint> sorted = cut;
  std::stable_sort(sorted.begin(), sorted.end(), lower_angle);
  return sorted;
}

double widest_gap(const std::vector<CutPoint>& cut) {
  double widest = 0.0;
  for (std::size_t i = 1; i < cut.size(); ++i) {
    widest = std::max(widest, std::abs(cut[i].angle_deg - cut[i - 1].angle_deg));
  }
  return widest;
}

void close_where_all_around(std::vector<CutPoint>& cut) {
  constexpr double widest_to_bridge = 60.0;  // [deg]
  constexpr double rounding = 1e-9;          // of angles made by from + k step [deg]
  if (cut.size() < 3) return;
  const double covered = cut.back().angle_deg - cut.front().angle_deg;
  const double gap = turn - std::abs(covered);
  if (gap < rounding || gap > std::min(widest_to_bridge, widest_gap(cut) + rounding)) return;
  CutPoint again = cut.front();
  again.angle_deg += std::copysign(turn, covered);
  cut.push_back(again);
}

constexpr double infinity = std::numeric_limits<double>::infinity();

// lowest, highest: of the points that are not zero [dBsm].
struct Extremes {
  double lowest = infinity;
  double highest = -infinity;
  double band = -infinity;  // the highest top of a band that shows
  bool zeros = false;
};

constexpr double least_rise = 0.02;  // [dB]

Extremes extremes(const std::vector<std::vector<CutPoint>>& cuts) {
  Extremes found;
  for (const auto& cut : cuts) {
    for (const CutPoint& point : cut) {
      found.highest = std::max(found.highest, point.dbsm);
      if (point.high_dbsm > point.dbsm + least_rise) found.band = std::max(found.band, point.high_dbsm);
      if (point.dbsm == -infinity) found.zeros = true;
      if (point.dbsm > -infinity) found.lowest = std::min(found.lowest, point.dbsm);
    }
  }
  return found;
}

CutPoint crossing(const CutPoint& a, const CutPoint& b, double floor) {
  const double share = (floor - a.dbsm) / (b.dbsm - a.dbsm);
  return {std::lerp(a.angle_deg, b.angle_deg, share), floor};
}

}  // namespace

std::vector<CutPoint> cut_points(const Curve& curve, bool goes_round) {
  require_valid(curve);
  std::vector<CutPoint> cut;
  for (std::size_t i = 0; i < curve.angle_deg.size(); ++i) {
    const double sigma = curve.sigma_m2[i], bound = curve.bound_m2.empty() ? 0.0 : curve.bound_m2[i];
    cut.push_back(
        {curve.angle_deg[i], decibels(sigma), decibels(std::max(0.0, sigma - bound)), decibels(sigma + bound)});
  }
  if (goes_round) {
    cut = in_order(cut);
    close_where_all_around(cut);
  } else {
    std::stable_sort(cut.begin(), cut.end(), lower_angle);
  }
  return cut;
}

DecibelRange decibel_range(const std::vector<std::vector<CutPoint>>& cuts, double least_span,
                           std::optional<double> floor) {
  const Extremes found = extremes(cuts);
  DecibelRange range;
  range.all_zero = found.highest == -infinity;
  if (range.all_zero) return range;
  const double top = std::max(found.highest, found.band);
  if (floor) {
    if (*floor >= found.highest) throw std::invalid_argument("the floor of a plot must lie below its highest point");
    range.low = *floor;
    range.step = nice_step(top - range.low, 7);
    range.high = range.step * std::ceil(top / range.step);
  } else {
    const double foot = std::max(found.lowest, found.highest - deepest);
    const double missing = std::max(0.0, least_span - (found.highest - foot));
    range.step = nice_step(top - foot + missing, 7);
    range.low = range.step * std::floor((foot - 0.5 * missing) / range.step);
    range.high = range.step * std::ceil((top + 0.5 * missing) / range.step);
    // The lowest point shall not lie on the frame, nor in the centre of a polar plot.
    if (foot - range.low < 0.2 * range.step) range.low -= range.step;
  }
  range.floor_used = found.zeros || found.lowest < range.low;
  return range;
}

std::string floor_label(const DecibelRange& range) {
  return number_label(range.low, 6);
}

std::vector<std::vector<CutPoint>> strokes_above(const std::vector<CutPoint>& cut, double floor) {
  std::vector<std::vector<CutPoint>> strokes;
  bool drawing = false;
  for (std::size_t i = 0; i < cut.size(); ++i) {
    const bool above = cut[i].dbsm >= floor;
    const bool joined = i > 0 && std::isfinite(cut[i].dbsm) && std::isfinite(cut[i - 1].dbsm);
    if (above && !drawing) {
      strokes.emplace_back();
      if (joined) strokes.back().push_back(crossing(cut[i - 1], cut[i], floor));
    }
    if (above) strokes.back().push_back(cut[i]);
    if (!above && drawing && joined) strokes.back().push_back(crossing(cut[i - 1], cut[i], floor));
    drawing = above;
  }
  return strokes;
}

}  // namespace lrcs
