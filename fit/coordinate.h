#pragma once
#include <algorithm>
#include <cmath>

#include "brdf/form_list.h"

namespace lrcs {

// The coordinate in which a parameter is sought: 0 to 1 over the range in which a search begins, and on beyond it.
//   linear: even in the value; logarithmic: even in its logarithm;
//   ratio: value/(middle + value), middle the geometric mean of the range: 0 and 1 are the limits 0 and infinity, in
//   whose neighbourhood the model changes as little as the coordinate does.
[[nodiscard]] inline double middle_of(const FormParameter& p) {
  return std::sqrt(p.from * p.to);
}

[[nodiscard]] inline double coordinate_of(const FormParameter& p, double value) {
  switch (p.scale) {
    case FormParameter::Scale::logarithmic:
      return std::log(value / p.from) / std::log(p.to / p.from);
    case FormParameter::Scale::ratio:
      return value / (middle_of(p) + value);
    case FormParameter::Scale::linear:
      break;
  }
  return (value - p.from) / (p.to - p.from);
}

// Within [least, most].
[[nodiscard]] inline double value_at(const FormParameter& p, double coordinate) {
  double value = p.from + coordinate * (p.to - p.from);
  if (p.scale == FormParameter::Scale::logarithmic)
    value = p.from * std::exp(coordinate * std::log(p.to / p.from));
  else if (p.scale == FormParameter::Scale::ratio)
    value = coordinate < 1.0 ? middle_of(p) * coordinate / (1.0 - coordinate) : p.most;
  return std::clamp(value, p.least, p.most);
}

// d value / d coordinate.
[[nodiscard]] inline double slope_at(const FormParameter& p, double value) {
  switch (p.scale) {
    case FormParameter::Scale::logarithmic:
      return value * std::log(p.to / p.from);
    case FormParameter::Scale::ratio:
      return (middle_of(p) + value) * (1.0 + value / middle_of(p));
    case FormParameter::Scale::linear:
      break;
  }
  return p.to - p.from;
}

// Rounding of the coordinate aside; a linear parameter is as small as the data are.
[[nodiscard]] inline bool is_at_end(const FormParameter& p, double value) {
  if (p.is_linear) return value <= p.least || value >= p.most;
  const double from_least = coordinate_of(p, value) - coordinate_of(p, p.least);
  const double to_most = coordinate_of(p, p.most) - coordinate_of(p, value);
  return from_least <= 1e-12 || to_most <= 1e-12;
}

}  // namespace lrcs
