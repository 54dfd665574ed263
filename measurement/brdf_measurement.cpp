#include "measurement/brdf_measurement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/direction.h"

namespace lrcs {

void warn_of_one_incidence(BrdfMeasurement& measurement) {
  constexpr double same = 1e-3;
  const double first = measurement.samples.front().theta_i;
  const auto differs = [&](const BrdfSample& s) { return std::abs(s.theta_i - first) > same; };
  if (std::any_of(measurement.samples.begin(), measurement.samples.end(), differs)) return;
  measurement.warnings.push_back(
      fmt::format("only one angle of incidence, {:.6g} deg: what changes with it is not determined", first / degree));
}

const BrdfMeasurement* measured_at(const std::vector<BrdfMeasurement>& measurements, double wavelength) {
  constexpr double same = 1e-3;  // relative
  const auto apart = [&](const BrdfMeasurement& m) { return std::abs(m.wavelength - wavelength); };
  const auto nearest = std::min_element(measurements.begin(), measurements.end(),
                                        [&](const auto& a, const auto& b) { return apart(a) < apart(b); });
  return nearest != measurements.end() && apart(*nearest) <= same * wavelength ? &*nearest : nullptr;
}

}  // namespace lrcs
