#pragma once
#include <cmath>

#include "brdf/wu.h"

namespace lrcs {

// Wu's model as it is published, in the angles theta_i, theta_r, phi [rad], in long double: another route to the same
// numbers than the vectors of brdf/wu.h. Cancels where alpha is small, and is 0/0 at alpha = 0.
struct AngleForm {
  long double f_r, shadowing, sin_alpha;

  AngleForm(const WuParameters<double>& p, long double theta_i, long double theta_r, long double phi) {
    using std::cos;
    using std::sin;
    const long double ci = cos(theta_i);
    const long double cr = cos(theta_r);
    const long double si = sin(theta_i);
    const long double sr = sin(theta_r);
    const long double cos_gamma = std::sqrt((ci * cr + si * sr * cos(phi) + 1.0L) / 2.0L);
    const long double cos_alpha = (ci + cr) / (2.0L * cos_gamma);
    sin_alpha = std::sqrt(1.0L - cos_alpha * cos_alpha);
    const long double k = static_cast<long double>(p.kr) * p.kr;
    const long double lobe = k * cos_alpha / (1.0L + (k - 1.0L) * cos_alpha);
    const long double w = p.sigma_p * (1.0L + p.u_p * sin_alpha / (sin_alpha + p.v_p * cos_alpha));
    const long double tan_i = si / ci * (si + sr * cos(phi)) / (2.0L * sin_alpha * cos_gamma);
    const long double tan_r = sr / cr * (sr + si * cos(phi)) / (2.0L * sin_alpha * cos_gamma);
    const long double tan_gamma = std::abs(ci - cr) / (2.0L * sin_alpha * cos_gamma);
    shadowing = (1.0L + w * std::abs(tan_i * tan_r) / (1.0L + p.sigma_r * tan_gamma)) / (1.0L + w * tan_i * tan_i) /
                (1.0L + w * tan_r * tan_r);
    const long double fresnel = std::exp(p.b * std::pow(1.0L - cos_gamma, static_cast<long double>(p.a)));
    f_r = p.kb * lobe * fresnel * shadowing / (ci * cr) + p.kd / ci;
  }
};

}  // namespace lrcs
