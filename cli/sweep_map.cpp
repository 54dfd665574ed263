#include "cli/sweep_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "cli/sweep_cuts.h"

namespace lrcs {

std::optional<DirectionMap> direction_map(const std::vector<SweepRow>& rows) {
  std::set<double> azimuths, elevations;
  for (const SweepRow& row : rows) {
    azimuths.insert(row.aspect.transmitter.azimuth_deg);
    elevations.insert(row.aspect.transmitter.elevation_deg);
  }
  // A grid of more is not half full, and its size may not fit.
  if (azimuths.size() < 2 || elevations.size() < 2 || azimuths.size() > 2 * rows.size() / elevations.size())
    return std::nullopt;
  const double split = azimuth_before_nose({azimuths.begin(), azimuths.end()});
  const auto drawn = [&](double azimuth) { return azimuth < split ? azimuth : azimuth - 360.0; };
  DirectionMap map{{}, {elevations.begin(), elevations.end()}, {}};
  for (const double azimuth : azimuths) map.azimuth_deg.push_back(drawn(azimuth));
  std::sort(map.azimuth_deg.begin(), map.azimuth_deg.end());
  map.sigma_m2.assign(azimuths.size() * elevations.size(), std::numeric_limits<double>::quiet_NaN());
  const auto place_in = [](const std::vector<double>& angles, double angle) {
    return static_cast<std::size_t>(std::lower_bound(angles.begin(), angles.end(), angle) - angles.begin());
  };
  for (const SweepRow& row : rows) {
    const auto& [azimuth, elevation] = row.aspect.transmitter;
    map.sigma_m2[place_in(map.elevation_deg, elevation) * azimuths.size() + place_in(map.azimuth_deg, drawn(azimuth))] =
        row.sigma.value;
  }
  const auto missing = static_cast<std::size_t>(
      std::count_if(map.sigma_m2.begin(), map.sigma_m2.end(), [](double s) { return std::isnan(s); }));
  if (2 * missing > map.sigma_m2.size()) return std::nullopt;
  return map;
}

}  // namespace lrcs
