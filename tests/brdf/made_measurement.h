#pragma once
#include <functional>
#include <vector>

#include "brdf/brdf.h"
#include "brdf/pair_place.h"
#include "measurement/brdf_measurement.h"

namespace lrcs {

inline BrdfMeasurement measurement_of(std::vector<BrdfSample> samples) {
  return {"made.csv", "made", 0.0, std::move(samples), {}, {}};
}

// f_r of a BRDF at every theta_i, theta_r and phi [deg] of the lists.
inline BrdfMeasurement measured(const Brdf& brdf, const std::vector<double>& theta_i_deg,
                                const std::vector<double>& theta_r_deg, const std::vector<double>& phi_deg) {
  std::vector<BrdfSample> samples;
  for (const double i : theta_i_deg)
    for (const double r : theta_r_deg)
      for (const double phi : phi_deg)
        samples.push_back(
            {i * degree, r * degree, phi * degree, f_r_angles(brdf, i * degree, r * degree, phi * degree), 1.0, 0});
  return measurement_of(std::move(samples));
}

// from, from + step, ... to.
inline std::vector<double> steps(double from, double to, double step) {
  std::vector<double> values;
  for (int k = 0; from + k * step <= to + 1e-9; ++k) values.push_back(from + k * step);
  return values;
}

inline BrdfMeasurement measured_on_grid(const Brdf& brdf, double step_deg, double most_deg) {
  const auto zeniths = steps(0.0, most_deg, step_deg);
  return measured(brdf, zeniths, zeniths, steps(0.0, 180.0, 2.0 * step_deg));
}

// The place of a pair (brdf/pair_place.h) by its angles [rad].
inline Vec3 place_of_angles(double theta_i, double theta_r, double phi) {
  const Vec3 wi(std::sin(theta_i), 0.0, std::cos(theta_i));
  const Vec3 wr(std::sin(theta_r) * std::cos(phi), std::sin(theta_r) * std::sin(phi), std::cos(theta_r));
  return pair_place(wi, wr, Vec3::UnitZ());
}

}  // namespace lrcs
