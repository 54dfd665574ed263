#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "brdf/parameter_error.h"
#include "brdf/wu_terms.h"

namespace lrcs {

template <class T, class S>
class WuPair;

// Wu's semi-empirical surface: a coherent lobe of microfacets with shadowing, and a diffuse term.
// value: f_r cos_i cos_r = kb P exp[b (1 - cos gamma)^a] G + kd cos_r  [1/sr], bounded by largest().
//   With s = wi + wr, d = wi - wr, each split along n and along the surface, gamma = half the angle between wi and wr,
//   alpha = the angle between n and s, t = s_t/|s_t|, x_i = |wi.t|/cos_i, x_r = |wr.t|/cos_r:
//   P = kr^2 cos alpha/[1 + (kr^2 - 1) cos alpha], as cos alpha/{cos alpha + sin^2 alpha/[(1 + cos alpha) kr^2]}
//   w = sigma_p [1 + u_p sin alpha / (sin alpha + v_p cos alpha)]
//   G = [1 + w x_i x_r / (1 + sigma_r |cos_i - cos_r| / |s_t|)] / [(1 + w x_i^2)(1 + w x_r^2)]
// azimuth_of_specular: 180: as above, so that the azimuth between wi and wr is 0 at retro-reflection. 0: the mirrored
//   convention of some fits, where the formula's azimuth phi is 180 deg - phi of the geometry: wr is first turned by
//   180 deg about n, which exchanges s_t and d_t and leaves everything else.
// limits: retro: gamma = 0 and G = 1/(1 + w tan^2 theta), exactly; a, b, sigma_r drop out.
//   specular (s_t = 0, as far as rounding lets one tell): G depends on the approach; the value is that of the plane of
//   incidence, [1 + sigma_p tan^2/(1 + sigma_r tan)]/(1 + sigma_p tan^2)^2. grazing: f_r alone diverges, by kd/cos_i.
// domain: kb, kd, sigma_p, sigma_r, u_p >= 0; kr, a, v_p > 0; b finite, of either sign; largest() and
//   sigma_p (1 + u_p) finite; azimuth_of_specular 180 or 0. Else ParameterError. T: the scalar of the parameters.
// laws: NOT reciprocal: kd cos_r is not symmetric. The albedo can pass 1 near grazing (brdf/albedo.h).
// check: tests/brdf/wu_test.cpp: the angle form in long double, 1e-12; closed forms of the sphere.
// source: Wu et al., Acta Optica Sinica 22(8), 897-901, 2002 (five); Wang and Wu, Infrared and Laser Engineering 43(1),
//   332-337, 2014, eqs. (2), (3) (nine), with kr^2 - 1 and |cos_i - cos_r| where that print has kr - 1 and cos gamma.
template <class T>
class WuModel {
 public:
  static constexpr bool is_reciprocal = false;

  explicit WuModel(const WuParameters<T>& parameters);

  [[nodiscard]] const WuParameters<T>& parameters() const { return p_; }
  [[nodiscard]] bool conserves_energy() const { return false; }
  [[nodiscard]] double largest() const {
    return plain_value(p_.kb) * std::exp(std::max(plain_value(p_.b), 0.0)) + plain_value(p_.kd);
  }

  template <class S>
  [[nodiscard]] ResultScalar<T, S> f_cos_cos(const Direction<S>& wi, const Direction<S>& wr,
                                             const Direction<S>& n) const {
    return for_pair(wi, wr)(n);
  }

  // error: cos_theta above 1 is rounding and counts as 1.
  template <class S>
  [[nodiscard]] ResultScalar<T, S> f_cos_cos_retro(const S& cos_theta) const;

  // What depends on the pair alone is computed here, once.
  template <class S>
  [[nodiscard]] WuPair<T, S> for_pair(const Direction<S>& wi, const Direction<S>& wr) const {
    return WuPair<T, S>(p_, wi, wr);
  }

  // value: exp[b x^a], x = 1 - cos gamma, changes by |b| a x^a times the relative change of x, which the rounding of wi
  // and
  //   wr makes 8 u/|wi - wr| at most. In the mirrored convention x is another for each facet: the worst of all.
  [[nodiscard]] double pair_error(const Direction<double>& wi, const Direction<double>& wr) const {
    constexpr double u = std::numeric_limits<double>::epsilon() / 2.0;
    const double b = std::abs(plain_value(p_.b)), a = plain_value(p_.a);
    const auto at = [&](double chord) {
      return chord > 0.0 ? b * std::pow(chord * chord / 4.0, a) * (a / chord + 1.0) : 0.0;
    };
    const double worst = p_.azimuth_of_specular == 0 ? std::max(at(2.0), at(16.0 * u)) : at((wi - wr).norm());
    return 16.0 * u * worst;
  }

  // G alone [1], in [0, 1]; 0 where either cosine is not positive.
  template <class S>
  [[nodiscard]] ResultScalar<T, S> shadowing(const Direction<S>& wi, const Direction<S>& wr,
                                             const Direction<S>& n) const {
    return for_pair(wi, wr).shadowing(n);
  }

 private:
  WuParameters<T> p_;
};

using Wu = WuModel<double>;

// Wu's model for one pair of directions: a function of the normal. value: f_r cos_i cos_r [1/sr].
template <class T, class S>
class WuPair {
 public:
  using R = ResultScalar<T, S>;

  WuPair(const WuParameters<T>& parameters, const Direction<S>& wi, const Direction<S>& wr)
      : p_(parameters), wi_(wi), wr_(wr), length_((wi + wr).norm()) {
    lobe_height_ = p_.kb * wu_fresnel<R>(p_, S((wi - wr).squaredNorm() / S(4.0)), S(length_ / S(2.0)));
  }

  [[nodiscard]] R operator()(const Direction<S>& n) const {
    using std::sqrt;
    const auto g = wu_stance(wi_, wr_, n, is_mirrored());
    if (!is_above(g.cos_i) || !is_above(g.cos_r)) return R(0.0);
    S length = length_;
    R height = lobe_height_;
    if (is_mirrored()) {
      length = sqrt(g.s_n * g.s_n + g.s_t * g.s_t);
      height = p_.kb * wu_fresnel<R>(p_, S((g.d_n * g.d_n + g.d_t * g.d_t) / S(4.0)), S(length / S(2.0)));
    }
    return R(height * wu_lobe(R(p_.kr), g.s_n, g.s_t, length) * shadowing(g) + p_.kd * g.cos_r);
  }

  // Where one of these changes its sign over the normals, f_cos_cos has a crease: |cos_i - cos_r| has, and x_i or x_r,
  // whose direction's part along the surface is square there to that of wi + wr (of wi - wr in the mirrored
  // convention).
  [[nodiscard]] std::array<S, 3> creases(const Direction<S>& n) const {
    const S cos_i = n.dot(wi_), cos_r = n.dot(wr_), sign(is_mirrored() ? -1.0 : 1.0);
    const S along = S(1.0) + sign * wi_.dot(wr_);  // wi . (wi + wr)
    return {cos_i - cos_r, along - cos_i * (cos_i + sign * cos_r), along - cos_r * (cos_r + sign * cos_i)};
  }

  [[nodiscard]] R shadowing(const Direction<S>& n) const {
    const auto g = wu_stance(wi_, wr_, n, is_mirrored());
    return is_above(g.cos_i) && is_above(g.cos_r) ? shadowing(g) : R(0.0);
  }

 private:
  // Rounding of wi, wr and n to unit vectors, and of s_t itself: below it the direction of s_t is noise, and with it G.
  static constexpr double rounding_of_s_t = 16.0;  // units of epsilon

  [[nodiscard]] bool is_mirrored() const { return p_.azimuth_of_specular == 0; }

  [[nodiscard]] R shadowing(const WuStance<S>& g) const {
    using std::abs;
    const S half(0.5);
    if (g.s_t <= S(rounding_of_s_t) * std::numeric_limits<S>::epsilon()) {
      const S x = half * g.d_t;
      const R q = half * g.s_n / (half * g.s_n + p_.sigma_r * x);
      return wu_shadow(R(p_.sigma_p), g.cos_i, x, g.cos_r, x, q);
    }
    const R w = p_.sigma_p * (R(1.0) + p_.u_p * g.s_t / (g.s_t + p_.v_p * g.s_n));
    const R q = g.s_t / (g.s_t + p_.sigma_r * g.d_n);
    const S along = g.dot_t / g.s_t;
    return wu_shadow(w, g.cos_i, S(half * abs(g.s_t + along)), g.cos_r, S(half * abs(g.s_t - along)), q);
  }

  WuParameters<T> p_;
  Direction<S> wi_, wr_;
  S length_;  // |wi + wr| = 2 cos gamma
  R lobe_height_;
};

template <class T>
WuModel<T>::WuModel(const WuParameters<T>& parameters) : p_(parameters) {
  const auto positive = [](std::string_view name, const T& x) {
    const double value = plain_value(x);
    if (!(value > 0.0) || !std::isfinite(value)) throw ParameterError(name, fmt::format("{} > 0", name), value);
  };
  const auto not_negative = [](std::string_view name, const T& x) {
    const double value = plain_value(x);
    if (!(value >= 0.0) || !std::isfinite(value)) throw ParameterError(name, fmt::format("{} >= 0", name), value);
  };
  not_negative("kb", p_.kb);
  positive("kr", p_.kr);
  require_parameter("b", plain_value(p_.b), true, "a finite b");
  positive("a", p_.a);
  not_negative("kd", p_.kd);
  not_negative("sigma_p", p_.sigma_p);
  not_negative("sigma_r", p_.sigma_r);
  not_negative("u_p", p_.u_p);
  positive("v_p", p_.v_p);
  require_parameter("b", plain_value(p_.b), std::isfinite(largest()), "b such that kb exp(b) is finite");
  require_parameter("u_p", plain_value(p_.u_p), std::isfinite(plain_value(p_.sigma_p) * (1.0 + plain_value(p_.u_p))),
                    "u_p such that sigma_p (1 + u_p) is finite");
  require_parameter("azimuth_of_specular", p_.azimuth_of_specular,
                    p_.azimuth_of_specular == 180 || p_.azimuth_of_specular == 0, "azimuth_of_specular 180 or 0");
}

template <class T>
template <class S>
ResultScalar<T, S> WuModel<T>::f_cos_cos_retro(const S& cos_theta) const {
  using std::sqrt;
  using R = ResultScalar<T, S>;
  if (!is_above(cos_theta)) return R(0.0);
  const S one(1.0);
  const S cosine = cos_theta > one ? one : cos_theta;
  const S sin2 = (one - cosine) * (one + cosine);
  const S sine = sqrt(sin2);
  if (p_.azimuth_of_specular == 0) {
    const R q = cosine / (cosine + p_.sigma_r * sine);
    const R g = wu_shadow(R(p_.sigma_p), cosine, sine, cosine, sine, q);
    return R(p_.kb * wu_fresnel<R>(p_, sin2, cosine) * g + p_.kd * cosine);
  }
  const R w = p_.sigma_p * (R(1.0) + p_.u_p * sine / (sine + p_.v_p * cosine));
  const R g = cosine / (cosine + w * sine * (sine / cosine));
  return R(p_.kb * wu_lobe(R(p_.kr), cosine, sine, one) * g + p_.kd * cosine);
}

}  // namespace lrcs
