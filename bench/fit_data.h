#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "brdf/material.h"
#include "measurement/brdf_measurement.h"

namespace lrcs {

// A measurement made of a published material, with noise.
struct FitData {
  const Material* material = nullptr;
  double noise = 0.0;  // standard deviation of f_r over f_r [1]
  std::uint64_t seed = 0;
  BrdfMeasurement measurement;
};

// In the plane of incidence: theta_i 0, 10, 30, 50 deg; theta_r -80 to 80 deg in steps of 4, negative on the specular
// side. f_r (1 + noise g), g normal; never below 0. laws: the same bytes for the same seed.
[[nodiscard]] FitData fit_data(const Material& material, double noise, std::uint64_t seed);

// Every material of the library with every noise.
[[nodiscard]] std::vector<FitData> all_fit_data(const std::vector<double>& noises, std::uint64_t seed);

// The true values of a form's parameters: the nine, or the first five of them.
[[nodiscard]] std::vector<double> true_parameters(const Material& material, std::string_view form);

}  // namespace lrcs
