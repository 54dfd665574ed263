#pragma once
#include <cmath>
#include <numbers>

#include "brdf/beckmann.h"
#include "brdf/ggx.h"
#include "brdf/half_vector_model.h"
#include "brdf/parameter_error.h"

namespace lrcs {

// A rough surface of small mirrors (microfacets) over a diffuse one. Slopes: Beckmann or Ggx, how their slopes spread.
// value: f_r = kd/pi + ks F D G/(4 cos_i cos_r)  [1/sr]
//   F = f0 + (1 - f0)(1 - cos gamma)^5        reflectance of a mirror, gamma half the angle between wi and wr (Schlick)
//   D = lobe(alpha)/(pi roughness^2)          density of mirrors whose normal is at alpha from the surface's
//   G = 1/(1 + Lambda(wi) + Lambda(wr))       what mirrors do not hide from one another (Smith, heights correlated)
// domain: kd, ks >= 0; f0 in [0, 1]; roughness in [1e-6, 100], a narrower lobe is a mirror. Else ParameterError.
// laws: reciprocal; the albedo is at most kd + ks, for light that meets one mirror only is counted.
// check: tests/brdf/high_precision_test.cpp, 1e-12.
// source: R. Cook and K. Torrance, ACM TOG 1(1), 7, 1982; D and G: brdf/beckmann.h, brdf/ggx.h; F: C. Schlick, Computer
//   Graphics Forum 13(3), 233, 1994. The print of 1982 has G of V-shaped grooves and pi in place of 4 under D F G.
template <class T, class Slopes>
class CookTorranceModel : public HalfVectorModel<T, CookTorranceModel<T, Slopes>> {
 public:
  CookTorranceModel(const T& kd, const T& ks, const T& f0, const T& roughness)
      : kd_(kd), ks_(ks), f0_(f0), roughness_(roughness) {
    require_parameter_in("kd", plain_value(kd), 0.0, largest_parameter);
    require_parameter_in("ks", plain_value(ks), 0.0, largest_parameter);
    require_parameter_in("f0", plain_value(f0), 0.0, 1.0);
    require_parameter_in("roughness", plain_value(roughness), 1e-6, Slopes::largest_s);
  }

  [[nodiscard]] const T& kd() const { return kd_; }
  [[nodiscard]] const T& ks() const { return ks_; }
  [[nodiscard]] const T& f0() const { return f0_; }
  [[nodiscard]] const T& roughness() const { return roughness_; }
  [[nodiscard]] double largest() const {
    const double s = plain_value(roughness_);
    return (plain_value(kd_) + plain_value(ks_) * Slopes::highest(s) / (4.0 * s * s)) / std::numbers::pi;
  }
  [[nodiscard]] bool conserves_energy() const { return plain_value(kd_) + plain_value(ks_) <= 1.0; }

  [[nodiscard]] double lobe_error(const Direction<double>& wi, const Direction<double>& wr,
                                  const Direction<double>& n) const {
    const auto h = half_vector(wi, wr, n);
    return plain_value(ks_ * mirrors(h)) * lobe_rounding<Slopes>(plain_value(roughness_), h);
  }

 private:
  friend HalfVectorModel<T, CookTorranceModel>;

  // F D G / 4
  template <class S>
  [[nodiscard]] ResultScalar<T, S> mirrors(const HalfVector<S>& h) const {
    using R = ResultScalar<T, S>;
    const R s(roughness_);
    const S x2 = h.one_less_cos * h.one_less_cos;
    const S grazing = x2 * x2 * h.one_less_cos;
    const R reflectance = R(f0_) * R(S(S(1.0) - grazing)) + R(grazing);
    const R density = Slopes::lobe(s, h.cos2, h.sin2) / (s * s);
    return R(reflectance * density * Slopes::unmasked(s, h.cos_i, h.cos_r) / R(4.0L * std::numbers::pi_v<long double>));
  }

  template <class S>
  [[nodiscard]] ResultScalar<T, S> value(const HalfVector<S>& h) const {
    using R = ResultScalar<T, S>;
    return R(R(kd_) * R(h.product()) / R(std::numbers::pi_v<long double>) + R(ks_) * mirrors(h));
  }

  T kd_, ks_, f0_, roughness_;
};

template <class T>
using CookTorranceBeckmannModel = CookTorranceModel<T, Beckmann>;
template <class T>
using CookTorranceGgxModel = CookTorranceModel<T, Ggx>;

using CookTorranceBeckmann = CookTorranceBeckmannModel<double>;
using CookTorranceGgx = CookTorranceGgxModel<double>;

}  // namespace lrcs
