#pragma once
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "brdf/brdf_form.h"
#include "brdf/library.h"

namespace lrcs {

// BRDFs that the law tests run over: at least one of every model in the list (brdf_test.cpp checks that).
inline std::vector<Brdf> sample_brdfs() {
  std::vector<Brdf> samples{Lambert(1.0), Lambert(0.3), Lambert(0.0)};
  for (const Material& material : material_library()) {
    const BrdfWords words = words_of(material.brdf);
    samples.push_back(material.brdf);
    samples.push_back(words.form->make(words.values, 180 - words.azimuth_of_specular));
  }
  samples.emplace_back(Wu({.kb = 0.2, .kr = 1.0, .b = 1.5, .a = 2.0, .kd = 0.0, .sigma_p = 0.0, .sigma_r = 0.0}));
  samples.emplace_back(
      Wu({.kb = 0.2, .kr = 1e-3, .b = -3.0, .a = 0.3, .kd = 0.1, .sigma_p = 40.0, .sigma_r = 9.0, .v_p = 1e-3}));
  return samples;
}

class RandomDirections {
 public:
  explicit RandomDirections(unsigned seed) : engine_(seed) {}

  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(engine_); }
  Vec3 on_sphere() {
    std::normal_distribution<double> normal;
    return Vec3(normal(engine_), normal(engine_), normal(engine_)).normalized();
  }
  // Above the surface of normal n: uniform in the angles, so that grazing is not rare.
  Vec3 above(const Vec3& n, double largest_theta) {
    const double theta = uniform(0.0, largest_theta);
    const Vec3 side = n.cross(on_sphere()).normalized();
    return (std::cos(theta) * n + std::sin(theta) * side).normalized();
  }

 private:
  std::mt19937 engine_;
};

inline Vec3 from_angles(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

template <class... Arguments>
double f_cos_cos(const Brdf& brdf, const Arguments&... arguments) {
  return std::visit([&](const auto& model) { return model.f_cos_cos(arguments...); }, brdf);
}

}  // namespace lrcs
