#pragma once
#include <cmath>
#include <utility>

#include "brdf/scalar.h"

namespace lrcs {

// The numbers of Wu's model. The five-parameter form is the nine-parameter one with the empirical shadowing constants.
template <class T>
struct WuParameters {
  T kb{}, kr{}, b{}, a{}, kd{};
  T sigma_p = T(0.0136), sigma_r = T(0.0136), u_p = T(9.0), v_p = T(1.0);
  int azimuth_of_specular = 180;  // [deg] 180 or 0

  [[nodiscard]] bool has_empirical_shadowing() const {
    return sigma_p == T(0.0136) && sigma_r == T(0.0136) && u_p == T(9.0) && v_p == T(1.0);
  }
};

// How the pair wi, wr stands to one normal, after the turn that azimuth_of_specular = 0 asks for.
template <class S>
struct WuStance {
  S cos_i, cos_r;
  S s_n, s_t;  // s along n; length of s along the surface
  S d_n, d_t;  // the same of d
  S dot_t;     // s_t . d_t
};

template <class S>
[[nodiscard]] WuStance<S> wu_stance(const Direction<S>& wi, const Direction<S>& wr, const Direction<S>& n,
                                    bool is_mirrored) {
  using std::abs;
  const Direction<S> s = wi + wr;
  const Direction<S> d = wi - wr;
  const S s_n = s.dot(n);
  const S d_n = d.dot(n);
  const Direction<S> s_t = s - s_n * n;
  const Direction<S> d_t = d - d_n * n;
  WuStance<S> g{wi.dot(n), wr.dot(n), s_n, s_t.norm(), abs(d_n), d_t.norm(), s_t.dot(d_t)};
  if (is_mirrored) std::swap(g.s_t, g.d_t);
  return g;
}

// P. sn, st: of s, to one scale.
template <class R, class S>
[[nodiscard]] R wu_lobe(const R& kr, const S& s_n, const S& s_t, const S& length) {
  const R slope = s_t / kr;
  return R(s_n / (s_n + slope * slope / (length + s_n)));
}

// exp[b (1 - cos gamma)^a] from sin^2 gamma and cos gamma, without cancellation, and with a derivative at gamma = 0.
template <class R, class T, class S>
[[nodiscard]] R wu_fresnel(const WuParameters<T>& p, const S& sin2_gamma, const S& cos_gamma) {
  using std::exp;
  using std::pow;
  const S x = sin2_gamma / (S(1.0) + cos_gamma);
  return x > S(0.0) ? R(exp(p.b * pow(R(x), R(p.a)))) : R(1.0);
}

// G for x = |w.t| of both directions. q: 1/(1 + sigma_r tan gamma_p). Ordered so that no step overflows.
template <class R, class S>
[[nodiscard]] R wu_shadow(const R& w, const S& cos_i, const S& x_i, const S& cos_r, const S& x_r, const R& q) {
  const R i = R(1.0) / (cos_i + w * x_i * (x_i / cos_i));
  const R r = R(1.0) / (cos_r + w * x_r * (x_r / cos_r));
  return R((cos_i * i) * (cos_r * r) + (w * x_i * i) * (x_r * r) * q);
}

}  // namespace lrcs
