#pragma once
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "base/vec3.h"
#include "brdf/brdf.h"
#include "brdf/brdf_form.h"
#include "brdf/library.h"
#include "tests/brdf/made_measurement.h"

namespace lrcs {

// What a goniometer would measure in the plane of incidence: theta_i 0, 10, 30, 50 deg, theta_r -80 to 80 deg in steps
// of 4 deg (negative: phi = pi), each value times 1 + noise z, z normal; a value below 0 is 0.
inline std::vector<BrdfSample> goniometer_samples(const Brdf& brdf, double noise = 0.0, unsigned seed = 1) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> z;
  std::vector<BrdfSample> samples;
  for (const double i : {0.0, 10.0, 30.0, 50.0})
    for (int r = -80; r <= 80; r += 4) {
      BrdfSample s{i * degree, std::abs(r) * degree, r < 0 ? std::numbers::pi : 0.0};
      s.f_r = f_r_angles(brdf, s.theta_i, s.theta_r, s.phi) * std::max(1.0 + noise * z(engine), 0.0);
      s.line = static_cast<int>(samples.size()) + 2;
      samples.push_back(s);
    }
  return samples;
}

inline BrdfMeasurement at_1_06_um(std::vector<BrdfSample> samples) {
  BrdfMeasurement data = measurement_of(std::move(samples));
  data.wavelength = 1.06e-6;
  return data;
}

inline BrdfMeasurement goniometer_data(const Brdf& brdf, double noise = 0.0, unsigned seed = 1) {
  return at_1_06_um(goniometer_samples(brdf, noise, seed));
}

inline const Brdf& published(std::string_view name) {
  return find_in_library(name)->brdf;
}

// The parameters of the form that the BRDF is written in.
inline std::vector<double> truth_of(const Brdf& brdf) {
  return words_of(brdf).values;
}

}  // namespace lrcs
