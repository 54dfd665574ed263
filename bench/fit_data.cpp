#include "bench/fit_data.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "brdf/form_list.h"
#include "brdf/library.h"
#include "fit/uniform.h"

namespace lrcs {
namespace {

constexpr double radian = std::numbers::pi / 180.0;

// Of mean 0 and variance 1. source: Box and Muller, Annals of Mathematical Statistics 29(2), 610, 1958.
double normal(Uniform& random) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - random.next()));
  return radius * std::cos(2.0 * std::numbers::pi * random.next());
}

}  // namespace

FitData fit_data(const Material& material, double noise, std::uint64_t seed) {
  FitData data{&material, noise, seed, {}};
  data.measurement.name = material.name;
  data.measurement.wavelength = material.wavelength;
  Uniform random(seed);
  for (const int theta_i : {0, 10, 30, 50})
    for (int theta_r = -80; theta_r <= 80; theta_r += 4) {
      BrdfSample s;
      s.theta_i = radian * theta_i;
      s.theta_r = radian * std::abs(theta_r);
      s.phi = theta_r < 0 ? std::numbers::pi : 0.0;
      const double truth = f_r_angles(material.brdf, s.theta_i, s.theta_r, s.phi);
      s.f_r = std::max(truth * (1.0 + noise * normal(random)), 0.0);
      data.measurement.samples.push_back(s);
    }
  return data;
}

std::vector<FitData> all_fit_data(const std::vector<double>& noises, std::uint64_t seed) {
  std::vector<FitData> all;
  for (const Material& material : material_library())
    for (const double noise : noises) all.push_back(fit_data(material, noise, seed));
  return all;
}

std::vector<double> true_parameters(const Material& material, std::string_view form) {
  const auto nine = forms::NineParameterForm::values(std::get<Wu>(material.brdf));
  const std::size_t size = form == forms::FiveParameterForm::name ? 5 : 9;
  return {nine.begin(), nine.begin() + static_cast<std::ptrdiff_t>(size)};
}

}  // namespace lrcs
