#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/brdf/sample_brdfs.h"

namespace lrcs {
namespace {

// The least dual number that a model needs as the scalar of its parameters: a value and one derivative.
struct Dual {
  double x = 0.0;
  double d = 0.0;
  Dual() = default;
  Dual(double value) : x(value) {}  // NOLINT(google-explicit-constructor): a number is a constant
  Dual(double value, double derivative) : x(value), d(derivative) {}
  [[nodiscard]] double value() const { return x; }
};
Dual operator+(const Dual& a, const Dual& b) {
  return {a.x + b.x, a.d + b.d};
}
Dual operator*(const Dual& a, const Dual& b) {
  return {a.x * b.x, a.d * b.x + a.x * b.d};
}
Dual operator/(const Dual& a, const Dual& b) {
  return {a.x / b.x, (a.d - a.x / b.x * b.d) / b.x};
}
Dual exp(const Dual& a) {
  return {std::exp(a.x), a.d * std::exp(a.x)};
}
Dual pow(const Dual& a, const Dual& b) {
  const double p = std::pow(a.x, b.x);
  return {p, p * (b.d * std::log(a.x) + b.x * a.d / a.x)};
}

template <class T>
using Parameter = T WuParameters<T>::*;

constexpr std::array<Parameter<double>, 9> parameters{
    &WuParameters<double>::kb,      &WuParameters<double>::kr,  &WuParameters<double>::b,
    &WuParameters<double>::a,       &WuParameters<double>::kd,  &WuParameters<double>::sigma_p,
    &WuParameters<double>::sigma_r, &WuParameters<double>::u_p, &WuParameters<double>::v_p};
constexpr std::array<Parameter<Dual>, 9> dual_parameters{
    &WuParameters<Dual>::kb,      &WuParameters<Dual>::kr,  &WuParameters<Dual>::b,
    &WuParameters<Dual>::a,       &WuParameters<Dual>::kd,  &WuParameters<Dual>::sigma_p,
    &WuParameters<Dual>::sigma_r, &WuParameters<Dual>::u_p, &WuParameters<Dual>::v_p};

// The parameters as dual numbers, the derivative being with respect to number `active`.
WuParameters<Dual> dual(const WuParameters<double>& p, std::size_t active) {
  WuParameters<Dual> q;
  for (std::size_t k = 0; k < parameters.size(); ++k)
    q.*dual_parameters[k] = Dual(p.*parameters[k], k == active ? 1 : 0);
  q.azimuth_of_specular = p.azimuth_of_specular;
  return q;
}

// Fourth-order central difference.
double difference(WuParameters<double> p, std::size_t active, const Vec3& wi, const Vec3& wr, const Vec3& n) {
  const double x = p.*parameters[active];
  const double h = 1e-3 * std::abs(x);
  const auto f = [&](double shift) {
    p.*parameters[active] = x + shift;
    return Wu(p).f_cos_cos(wi, wr, n);
  };
  return (8.0 * (f(h) - f(-h)) - (f(2.0 * h) - f(-2.0 * h))) / (12.0 * h);
}

TEST(WuDerivatives, WithRespectToEveryParameterComeFromDualNumbers) {
  RandomDirections random(21);
  for (const Brdf& brdf : sample_brdfs()) {
    const Wu* model = std::get_if<Wu>(&brdf);
    if (model == nullptr || model->parameters().sigma_p <= 0.0) continue;
    for (int k = 0; k < 200; ++k) {
      const Vec3 n = random.on_sphere();
      const Vec3 wi = random.above(n, 1.5);
      const Vec3 wr = random.above(n, 1.5);
      for (std::size_t active = 0; active < parameters.size(); ++active) {
        const Dual value = WuModel<Dual>(dual(model->parameters(), active)).f_cos_cos(wi, wr, n);
        EXPECT_NEAR(value.x, model->f_cos_cos(wi, wr, n), 1e-15);
        const double scale = std::abs(model->parameters().*parameters[active]);
        if (scale == 0.0) continue;
        const double expected = difference(model->parameters(), active, wi, wr, n);
        EXPECT_NEAR(scale * value.d, scale * expected, 1e-9 * model->largest()) << active;
      }
    }
  }
}

TEST(WuDerivatives, AreNumbersAtRetroReflectionAndWithoutShadowing) {
  WuParameters<double> p = std::get<Wu>(find_in_library("metal-skin-5p")->brdf).parameters();
  p.sigma_p = 0.0;
  const Vec3 w = from_angles(0.7, 0.3);
  for (std::size_t active = 0; active < parameters.size(); ++active) {
    const WuModel<Dual> model(dual(p, active));
    EXPECT_TRUE(std::isfinite(model.f_cos_cos(w, w, Vec3(0, 0, 1)).d)) << active;
    EXPECT_NEAR(model.f_cos_cos_retro(w.z()).d, model.f_cos_cos(w, w, Vec3(0, 0, 1)).d, 1e-13) << active;
  }
}

}  // namespace
}  // namespace lrcs
