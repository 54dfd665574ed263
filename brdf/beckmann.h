#pragma once
#include <algorithm>
#include <cmath>

#include "brdf/scalar.h"

namespace lrcs {

// A rough surface whose slopes are Gaussian: s is sqrt(2) times their root mean square along one direction.
// source: P. Beckmann and A. Spizzichino, 1963; masking: B. Walter et al., EGSR 2007; E. Heitz, JCGT 3(2), 48, 2014.
struct Beckmann {
  static constexpr double largest_s = 100.0;

  // value: exp(-tan^2 alpha / s^2) / cos^4 alpha [1], 1 at alpha = 0; cos2, sin2: cos^2 and sin^2 of alpha.
  //   Divided by pi s^2 it is the density of facets per solid angle.
  // error: 0 where the exponent passes 700, where the value is below 1e-289 for s of at most largest_s.
  template <class R, class S>
  [[nodiscard]] static R lobe(const R& s, const S& cos2, const S& sin2) {
    using std::exp;
    const double s0 = plain_value(s);
    if (!(sin2 < S(700.0 * s0 * s0) * cos2)) return R(0.0);
    return R(exp(R(S(-sin2 / cos2)) / (s * s)) / R(S(cos2 * cos2)));
  }

  // value: the largest that lobe() can be.
  [[nodiscard]] static double highest(double s) {
    const double s2 = s * s;
    return s2 <= 0.5 ? 1.0 : 4.0 * s2 * s2 * std::exp(1.0 / s2 - 2.0);
  }

  // value: a bound of |d ln lobe / d tan alpha|.
  [[nodiscard]] static double steepness(double s, double tan_alpha) {
    return 2.0 * tan_alpha / (s * s) + 4.0 * tan_alpha / (1.0 + tan_alpha * tan_alpha);
  }

  // value: what masking and shadowing leave of a facet seen from both directions [1], heights of the two correlated.
  // domain: cosines positive, at most 1.
  template <class R, class S>
  [[nodiscard]] static R unmasked(const R& s, const S& cos_i, const S& cos_r) {
    return R(R(1.0) / (R(1.0) + masked_area(s, cos_i) + masked_area(s, cos_r)));
  }

 private:
  // Smith's Lambda. error: 0 where it is less than a rounding of 1.
  template <class R, class S>
  [[nodiscard]] static R masked_area(const R& s, const S& cos_theta) {
    using std::erfc;
    using std::exp;
    using std::sqrt;
    const S sine = sqrt((S(1.0) - cos_theta) * (S(1.0) + cos_theta));
    if (!(cos_theta < S(7.0 * plain_value(s)) * sine)) return R(0.0);
    const R x = R(S(cos_theta / sine)) / s;
    const R root_pi(1.772453850905516027298167483341145183L);
    return R((exp(-(x * x)) / (x * root_pi) - erfc(x)) / R(2.0));
  }
};

}  // namespace lrcs
