#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/direction.h"

namespace lrcs {

// Are directions all pairs of some azimuths, running fastest, and some elevations? Then the number of azimuths, else 0.
[[nodiscard]] inline std::size_t azimuths_of_grid(const std::vector<AspectAngles>& directions) {
  const auto other = std::find_if(directions.begin(), directions.end(), [&](const AspectAngles& a) {
    return a.elevation_deg != directions.front().elevation_deg;
  });
  const auto azimuths = static_cast<std::size_t>(other - directions.begin());
  if (azimuths == 0 || directions.size() % azimuths != 0) return 0;
  for (std::size_t k = 0; k < directions.size(); ++k)
    if (directions[k].azimuth_deg != directions[k % azimuths].azimuth_deg ||
        directions[k].elevation_deg != directions[k - k % azimuths].elevation_deg)
      return 0;
  return azimuths;
}

}  // namespace lrcs
