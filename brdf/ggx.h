#pragma once
#include <cmath>

#include "brdf/scalar.h"

namespace lrcs {

// A rough surface with more steep slopes than a Gaussian one has: the members are those of Beckmann (brdf/beckmann.h).
// source: T. S. Trowbridge and K. P. Reitz, JOSA 65(5), 531, 1975; B. Walter et al., EGSR 2007, there named GGX.
struct Ggx {
  static constexpr double largest_s = 100.0;

  // value: s^4 / (s^2 cos^2 alpha + sin^2 alpha)^2.
  template <class R, class S>
  [[nodiscard]] static R lobe(const R& s, const S& cos2, const S& sin2) {
    const R s2 = s * s;
    const R q = s2 / (s2 * R(cos2) + R(sin2));
    return R(q * q);
  }

  [[nodiscard]] static double highest(double s) { return s <= 1.0 ? 1.0 : s * s * s * s; }

  [[nodiscard]] static double steepness(double s, double tan_alpha) {
    const double t2 = tan_alpha * tan_alpha;
    return 4.0 * tan_alpha / (s * s + t2) + 4.0 * tan_alpha / (1.0 + t2);
  }

  template <class R, class S>
  [[nodiscard]] static R unmasked(const R& s, const S& cos_i, const S& cos_r) {
    const R i = root(s, cos_i);
    const R r = root(s, cos_r);
    return R(R(S(S(2.0) * cos_i * cos_r)) / (i * R(cos_r) + r * R(cos_i)));
  }

 private:
  template <class R, class S>
  [[nodiscard]] static R root(const R& s, const S& cos_theta) {
    using std::sqrt;
    const S sin2 = (S(1.0) - cos_theta) * (S(1.0) + cos_theta);
    return R(sqrt(R(S(cos_theta * cos_theta)) + s * s * R(sin2)));
  }
};

}  // namespace lrcs
