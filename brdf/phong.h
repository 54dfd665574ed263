#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>

#include "brdf/model_pair.h"
#include "brdf/parameter_error.h"
#include "brdf/scalar.h"

namespace lrcs {

// A diffuse surface with a cosine-power lobe about the specular direction.
// value: f_r = kd/pi + ks (m + 2)/(2 pi) cos^m beta  [1/sr], beta between wr and the specular direction of wi;
//   no lobe where beta is 90 deg or more.
// domain: kd, ks >= 0; m in [1, 1e8]. Else ParameterError.
// laws: reciprocal; the albedo is at most kd + ks.
// check: tests/brdf/high_precision_test.cpp, 1e-12.
// source: B. T. Phong, CACM 18(6), 311, 1975; E. Lafortune and Y. Willems, report CW 197, KU Leuven, 1994 (the factor).
template <class T>
class PhongModel {
 public:
  static constexpr bool is_reciprocal = true;

  PhongModel(const T& kd, const T& ks, const T& m) : kd_(kd), ks_(ks), m_(m) {
    require_parameter_in("kd", plain_value(kd), 0.0, largest_parameter);
    require_parameter_in("ks", plain_value(ks), 0.0, largest_parameter);
    require_parameter_in("m", plain_value(m), 1.0, 1e8);
  }

  [[nodiscard]] const T& kd() const { return kd_; }
  [[nodiscard]] const T& ks() const { return ks_; }
  [[nodiscard]] const T& m() const { return m_; }
  [[nodiscard]] double largest() const {
    return plain_value(kd_) / std::numbers::pi + plain_value(ks_) * (plain_value(m_) + 2.0) / (2.0 * std::numbers::pi);
  }
  [[nodiscard]] bool conserves_energy() const { return plain_value(kd_) + plain_value(ks_) <= 1.0; }

  template <class S>
  [[nodiscard]] ResultScalar<T, S> f_cos_cos(const Direction<S>& wi, const Direction<S>& wr,
                                             const Direction<S>& n) const {
    const S cos_i = wi.dot(n);
    const S cos_r = wr.dot(n);
    if (!is_above(cos_i) || !is_above(cos_r)) return ResultScalar<T, S>(0.0);
    return value(S(cos_i * cos_r), chord2(wi, wr, n));
  }

  template <class S>
  [[nodiscard]] ResultScalar<T, S> f_cos_cos_retro(const S& cos_theta) const {
    const S one(1.0);
    const S cosine = cos_theta > one ? one : cos_theta;
    if (!is_above(cosine)) return ResultScalar<T, S>(0.0);
    return value(S(cosine * cosine), S(S(4.0) * (one - cosine) * (one + cosine)));
  }

  template <class S>
  [[nodiscard]] ModelPair<PhongModel, S> for_pair(const Direction<S>& wi, const Direction<S>& wr) const {
    return {*this, wi, wr};
  }

  [[nodiscard]] double pair_error(const Direction<double>& /*wi*/, const Direction<double>& /*wr*/) const {
    return 0.0;
  }

  [[nodiscard]] double lobe_error(const Direction<double>& wi, const Direction<double>& wr,
                                  const Direction<double>& n) const {
    const double chord = std::sqrt(chord2(wi, wr, n));
    const double closer = std::max(chord - 16.0 * 0x1p-53, 0.0);
    const double change = plain_value(lobe(closer * closer)) - plain_value(lobe(chord * chord));
    return plain_value(ks_) * change * wi.dot(n) * wr.dot(n);
  }

 private:
  // |wr - (2 cos_i n - wi)|^2 = 2 - 2 cos beta, without cancellation near the specular direction; the same both ways.
  template <class S>
  [[nodiscard]] static S chord2(const Direction<S>& wi, const Direction<S>& wr, const Direction<S>& n) {
    const Direction<S> s = wi + wr;
    const S d_n = wi.dot(n) - wr.dot(n);
    return Direction<S>(s - s.dot(n) * n).squaredNorm() + d_n * d_n;
  }

  // (m + 2)/(2 pi) cos^m beta
  template <class S>
  [[nodiscard]] ResultScalar<T, S> lobe(const S& chord2) const {
    using R = ResultScalar<T, S>;
    using std::exp;
    using std::log1p;
    if (!(chord2 < S(2.0))) return R(0.0);
    const R m(m_);
    return R(exp(m * R(S(log1p(S(S(-0.5) * chord2))))) * (m + R(2.0)) / R(2.0L * std::numbers::pi_v<long double>));
  }

  template <class S>
  [[nodiscard]] ResultScalar<T, S> value(const S& cos_cos, const S& chord2) const {
    using R = ResultScalar<T, S>;
    return R((R(kd_) / R(std::numbers::pi_v<long double>) + R(ks_) * lobe(chord2)) * R(cos_cos));
  }

  T kd_, ks_, m_;
};

using Phong = PhongModel<double>;

}  // namespace lrcs
