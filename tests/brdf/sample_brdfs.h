#pragma once
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "brdf/brdf_form.h"
#include "brdf/library.h"
#include "tests/brdf/made_measurement.h"

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
  samples.emplace_back(Steinvall(0.8, 0.1, 0.2, 1.5));
  samples.emplace_back(Steinvall(3.0, 0.0, 1.7, 0.0));
  samples.emplace_back(Phong(0.3, 0.5, 25.0));
  samples.emplace_back(Phong(0.0, 1.0, 1.0));
  samples.emplace_back(CookTorranceBeckmann(0.2, 0.7, 0.04, 0.3));
  samples.emplace_back(CookTorranceBeckmann(0.0, 1.0, 0.9, 1.4));
  samples.emplace_back(CookTorranceGgx(0.3, 0.6, 0.5, 0.15));
  samples.emplace_back(CookTorranceGgx(0.0, 1.0, 0.0, 2.0));
  const Brdf measured_one = CookTorranceGgx(0.3, 0.6, 0.5, 0.4);
  samples.emplace_back(Tabulated(measured_on_grid(measured_one, 10.0, 80.0), Outside::nearest));
  samples.emplace_back(
      Tabulated(measured(measured_one, {0.0, 20.0, 60.0}, steps(0.0, 70.0, 5.0), {0.0, 180.0}), Outside::nearest));
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

// How far rounding of the directions may move a narrow lobe (brdf/brdf.h); 0 of models without one.
inline double lobe_error(const Brdf& brdf, const Vec3& wi, const Vec3& wr, const Vec3& n) {
  return std::visit(
      [&](const auto& model) {
        if constexpr (requires { model.lobe_error(wi, wr, n); })
          return model.lobe_error(wi, wr, n);
        else
          return 0.0;
      },
      brdf);
}

}  // namespace lrcs
