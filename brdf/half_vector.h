#pragma once
#include <algorithm>
#include <cmath>

#include "brdf/scalar.h"

namespace lrcs {

// How the half vector (wi + wr)/|wi + wr| stands to one normal: alpha is the angle between the two.
template <class S>
struct HalfVector {
  S cos_i, cos_r;
  S cos2, sin2;    // of alpha
  S one_less_cos;  // 1 - cos gamma, gamma half the angle between wi and wr

  [[nodiscard]] S product() const { return cos_i * cos_r; }
};

// A cosine above 1 is rounding and counts as 1.
template <class S>
[[nodiscard]] S at_most_one(const S& cosine) {
  return cosine > S(1.0) ? S(1.0) : cosine;
}

// domain: both directions above the surface.
template <class S>
[[nodiscard]] HalfVector<S> half_vector(const Direction<S>& wi, const Direction<S>& wr, const Direction<S>& n) {
  const Direction<S> s = wi + wr;
  const Direction<S> h = s / s.cwiseAbs().maxCoeff();  // of opposite directions s may be so short that its square is 0
  const S h_n = h.dot(n);
  const S h_t2 = Direction<S>(h - h_n * n).squaredNorm();
  const S all = h_n * h_n + h_t2;
  const S sin2_gamma = S(0.25) * (wi - wr).squaredNorm();
  return {at_most_one(S(wi.dot(n))), at_most_one(S(wr.dot(n))), h_n * h_n / all, h_t2 / all,
          sin2_gamma / (S(1.0) + S(0.5) * s.norm())};
}

// The same at wi = wr.
template <class S>
[[nodiscard]] HalfVector<S> half_vector_retro(const S& cos_theta) {
  const S cosine = at_most_one(cos_theta);
  return {cosine, cosine, cosine * cosine, (S(1.0) - cosine) * (S(1.0) + cosine), S(0.0)};
}

// value: how much the lobe of such a surface may change [1, relative] by rounding of the directions and the normal.
template <class Slopes>
[[nodiscard]] double lobe_rounding(double s, const HalfVector<double>& h) {
  const double tan_alpha = std::sqrt(h.sin2 / h.cos2);
  const double angle = 16.0 * 0x1p-53 / std::min(h.cos_i, h.cos_r);
  return Slopes::steepness(s, tan_alpha) * angle / h.cos2;
}

}  // namespace lrcs
