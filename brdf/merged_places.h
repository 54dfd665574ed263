#pragma once
#include <cstddef>
#include <vector>

#include "base/vec3.h"

namespace lrcs {

// Measured values at places.
struct PlacedValues {
  std::vector<Vec3> places;
  std::vector<double> values;
  std::vector<double> weights;  // [1] > 0
};

// The same with places closer than the tolerance taken for one, the first of them: its value is their mean by weight.
// laws: each place kept is more than the tolerance from every other.
struct MergedPlaces {
  PlacedValues merged;
  std::size_t repeated = 0;  // places that had more than one value
  double spread = 0.0;       // [1] of those: root of the mean square of value - mean, over that of the mean
};
[[nodiscard]] MergedPlaces merge_places(const PlacedValues& given, double tolerance);

}  // namespace lrcs
