#include "cli/sweep_cuts.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

namespace lrcs {
namespace {

// Rows of equal `fixed` angle make a cut against the other one, in rising order. Of rows with the same angles the last
// one counts.
std::vector<ViewedCut> cuts_along(const std::vector<SweepRow>& rows, double AspectAngles::*fixed,
                                  double AspectAngles::*running, const char* name) {
  std::map<double, std::map<double, std::size_t>> row_at;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const AspectAngles& angles = rows[row].aspect.transmitter;
    row_at[angles.*fixed][angles.*running] = row;
  }
  std::vector<ViewedCut> cuts;
  for (const auto& [at, points] : row_at) {
    ViewedCut& cut = cuts.emplace_back();
    cut.curve.label = fmt::format("{} {} deg", name, at);
    for (const auto& [angle, row] : points) {
      cut.curve.angle_deg.push_back(angle);
      cut.curve.sigma_m2.push_back(rows[row].sigma.value);
      cut.curve.bound_m2.push_back(rows[row].sigma.bound);
      cut.rows.push_back(row);
    }
  }
  return cuts;
}

void join_across_nose(ViewedCut& cut) {
  std::vector<double>& angles = cut.curve.angle_deg;
  const auto split = std::lower_bound(angles.begin(), angles.end(), azimuth_before_nose(angles));
  const auto first = split - angles.begin();
  std::for_each(split, angles.end(), [](double& angle) { angle -= 360.0; });
  const auto begin_with = [&](auto& values) { std::rotate(values.begin(), values.begin() + first, values.end()); };
  begin_with(angles), begin_with(cut.curve.sigma_m2), begin_with(cut.curve.bound_m2), begin_with(cut.rows);
}

std::size_t longest(const std::vector<ViewedCut>& cuts) {
  std::size_t most = 0;
  for (const ViewedCut& cut : cuts) most = std::max(most, cut.rows.size());
  return most;
}

Cuts row_cut(const std::vector<SweepRow>& rows) {
  ViewedCut all{{"directions", {}, {}}, {}};
  for (std::size_t row = 0; row < rows.size(); ++row) {
    all.curve.angle_deg.push_back(static_cast<double>(row));
    all.curve.sigma_m2.push_back(rows[row].sigma.value);
    all.curve.bound_m2.push_back(rows[row].sigma.bound);
    all.rows.push_back(row);
  }
  return {{all}, "row of sweep.csv", CutAngle::other};
}

}  // namespace

std::vector<Curve> Cuts::curves(std::size_t most, std::size_t* left_out) const {
  std::vector<Curve> curves;
  for (std::size_t k = 0; k < std::min(most, cuts.size()); ++k) curves.push_back(cuts[k].curve);
  if (left_out != nullptr) *left_out = cuts.size() - curves.size();
  return curves;
}

double azimuth_before_nose(const std::vector<double>& rising) {
  constexpr double half_turn = 180.0, turn = 360.0;  // [deg]
  const auto gap =
      std::adjacent_find(rising.begin(), rising.end(), [&](double a, double b) { return b - a > half_turn; });
  const bool is_joined = gap != rising.end() && rising.back() - rising.front() < turn;
  return is_joined ? *(gap + 1) : std::numeric_limits<double>::infinity();
}

Cuts azimuth_cuts(const std::vector<SweepRow>& rows) {
  Cuts cuts{cuts_along(rows, &AspectAngles::elevation_deg, &AspectAngles::azimuth_deg, "elevation"), "azimuth [deg]",
            CutAngle::azimuth};
  for (ViewedCut& cut : cuts.cuts) join_across_nose(cut);
  return cuts;
}

Cuts elevation_cuts(const std::vector<SweepRow>& rows) {
  return {cuts_along(rows, &AspectAngles::azimuth_deg, &AspectAngles::elevation_deg, "azimuth"), "elevation [deg]",
          CutAngle::elevation};
}

Cuts cuts_of(const std::vector<SweepRow>& rows) {
  Cuts cuts = azimuth_cuts(rows);
  if (longest(cuts.cuts) <= 1 && rows.size() > 1) cuts = elevation_cuts(rows);
  return longest(cuts.cuts) <= 1 && rows.size() > 1 ? row_cut(rows) : cuts;
}

Cuts cuts_of_all(const std::vector<SweepRow>& rows) {
  Cuts cuts = cuts_of(rows);
  std::size_t on_cuts = 0;
  for (const ViewedCut& cut : cuts.cuts) on_cuts += cut.rows.size();
  const bool is_scattered = rows.size() > 1 && 2 * cuts.cuts.size() > rows.size();
  return on_cuts < rows.size() || is_scattered ? row_cut(rows) : cuts;
}

ViewedSweep viewed_sweep(const std::vector<SweepRow>& rows, const FacetMesh& mesh, std::string title) {
  Cuts cuts = cuts_of_all(rows);
  ViewedSweep sweep{&mesh, std::move(title), {"", cuts.axis, cuts.angle}, std::move(cuts.cuts), {}, {}, {}};
  sweep.places.resize(rows.size());
  for (std::size_t cut = 0; cut < sweep.cuts.size(); ++cut)
    for (std::size_t point = 0; point < sweep.cuts[cut].rows.size(); ++point)
      sweep.places[sweep.cuts[cut].rows[point]] = {cut, point};
  for (const SweepRow& row : rows) {
    sweep.sigma_m2.push_back(row.sigma.value);
    sweep.bound_m2.push_back(row.sigma.bound);
  }
  return sweep;
}

}  // namespace lrcs
