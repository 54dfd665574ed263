#include "cli/sweep_cuts.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace lrcs {
namespace {

// Rows of equal `fixed` angle make a curve against the other one, in rising order.
std::vector<Curve> curves_of(const std::vector<SweepRow>& rows, double AspectAngles::*fixed,
                             double AspectAngles::*running, const char* name) {
  std::map<double, std::map<double, double>> sigma;
  for (const SweepRow& row : rows)
    sigma[row.aspect.transmitter.*fixed][row.aspect.transmitter.*running] = row.sigma.value;
  std::vector<Curve> curves;
  for (const auto& [at, points] : sigma) {
    Curve curve;
    curve.label = fmt::format("{} {} deg", name, at);
    for (const auto& [angle, value] : points) {
      curve.angle_deg.push_back(angle);
      curve.sigma_m2.push_back(value);
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

std::size_t longest(const std::vector<Curve>& curves) {
  std::size_t most = 0;
  for (const Curve& curve : curves) most = std::max(most, curve.angle_deg.size());
  return most;
}

}  // namespace

Cuts cuts_of(const std::vector<SweepRow>& rows) {
  Cuts cuts;
  cuts.axis = "azimuth (deg)";
  cuts.curves = curves_of(rows, &AspectAngles::elevation_deg, &AspectAngles::azimuth_deg, "elevation");
  if (longest(cuts.curves) <= 1 && rows.size() > 1) {
    cuts.axis = "elevation (deg)";
    cuts.angle = CutAngle::elevation;
    cuts.curves = curves_of(rows, &AspectAngles::azimuth_deg, &AspectAngles::elevation_deg, "azimuth");
  }
  if (longest(cuts.curves) <= 1 && rows.size() > 1) {
    cuts.axis = "row of sweep.csv";
    cuts.angle = CutAngle::other;
    Curve all{"directions", {}, {}};
    for (const SweepRow& row : rows) {
      all.angle_deg.push_back(static_cast<double>(all.angle_deg.size()));
      all.sigma_m2.push_back(row.sigma.value);
    }
    cuts.curves = {std::move(all)};
  }
  if (cuts.curves.size() > most_curves) {
    cuts.left_out = cuts.curves.size() - most_curves;
    cuts.curves.resize(most_curves);
  }
  return cuts;
}

}  // namespace lrcs
