#pragma once
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "brdf/brdf.h"

namespace lrcs {

// Every model as its source prints it, in angles, with 50 digits: another route than brdf/, which goes by vectors.
using Precise = boost::multiprecision::cpp_bin_float_50;

// theta_i, theta_r from the normal, phi between the azimuths (0 retro), all of the directions given, which count as
// exact; gamma, alpha of the half vector.
struct PreciseAngles {
  Precise cos_i, cos_r, sin_i, sin_r, cos_phi, cos_gamma, cos_alpha;

  PreciseAngles(const Vec3& wi, const Vec3& wr, const Vec3& n) {
    using Vector = std::array<Precise, 3>;
    const auto unit = [](const Vec3& w) {
      Vector v{w.x(), w.y(), w.z()};
      const Precise length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
      for (Precise& x : v) x /= length;
      return v;
    };
    const auto dot = [](const Vector& a, const Vector& b) { return Precise(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]); };
    const Vector i = unit(wi);
    const Vector r = unit(wr);
    const Vector z = unit(n);
    cos_i = dot(i, z);
    cos_r = dot(r, z);
    sin_i = sqrt(1 - cos_i * cos_i);
    sin_r = sqrt(1 - cos_r * cos_r);
    cos_phi = (dot(i, r) - cos_i * cos_r) / (sin_i * sin_r);
    cos_gamma = sqrt((cos_i * cos_r + sin_i * sin_r * cos_phi + 1) / 2);
    cos_alpha = (cos_i + cos_r) / (2 * cos_gamma);
  }
};

inline Precise precise_f_r(const Lambert& m, const PreciseAngles& /*angles*/) {
  return Precise(m.reflectance()) / boost::math::constants::pi<Precise>();
}

inline Precise precise_f_r(const Wu& m, const PreciseAngles& g) {
  const auto& p = m.parameters();
  const Precise cos_phi = p.azimuth_of_specular == 180 ? g.cos_phi : Precise(-g.cos_phi);
  const Precise cos_gamma = sqrt((g.cos_i * g.cos_r + g.sin_i * g.sin_r * cos_phi + 1) / 2);
  const Precise cos_alpha = (g.cos_i + g.cos_r) / (2 * cos_gamma);
  const Precise sin_alpha = sqrt(1 - cos_alpha * cos_alpha);
  const Precise k = Precise(p.kr) * p.kr;
  const Precise lobe = k * cos_alpha / (1 + (k - 1) * cos_alpha);
  const Precise w = p.sigma_p * (1 + p.u_p * sin_alpha / (sin_alpha + p.v_p * cos_alpha));
  const Precise tan_i = g.sin_i / g.cos_i * (g.sin_i + g.sin_r * cos_phi) / (2 * sin_alpha * cos_gamma);
  const Precise tan_r = g.sin_r / g.cos_r * (g.sin_r + g.sin_i * cos_phi) / (2 * sin_alpha * cos_gamma);
  const Precise tan_gamma = abs(g.cos_i - g.cos_r) / (2 * sin_alpha * cos_gamma);
  const Precise shadowing =
      (1 + w * abs(tan_i * tan_r) / (1 + p.sigma_r * tan_gamma)) / (1 + w * tan_i * tan_i) / (1 + w * tan_r * tan_r);
  return p.kb * lobe * exp(p.b * pow(1 - cos_gamma, Precise(p.a))) * shadowing / (g.cos_i * g.cos_r) + p.kd / g.cos_i;
}

inline Precise precise_f_r(const Steinvall& m, const PreciseAngles& g) {
  const Precise cos2 = g.cos_alpha * g.cos_alpha;
  const Precise tan2 = (1 - cos2) / cos2;
  const Precise cos_cos = g.cos_i * g.cos_r;
  return m.A() * exp(-tan2 / m.s() / m.s()) / (cos2 * cos2 * cos_cos) + m.B() * pow(cos_cos, Precise(m.m()) / 2);
}

inline Precise precise_f_r(const Phong& m, const PreciseAngles& g) {
  const Precise pi = boost::math::constants::pi<Precise>();
  const Precise cos_beta = g.cos_i * g.cos_r - g.sin_i * g.sin_r * g.cos_phi;
  const Precise lobe = cos_beta > 0 ? pow(cos_beta, Precise(m.m())) : Precise(0);
  return m.kd() / pi + m.ks() * (m.m() + 2) / (2 * pi) * lobe;
}

inline Precise precise_smith(const CookTorranceBeckmann& m, const Precise& cosine) {
  const Precise x = cosine / sqrt(1 - cosine * cosine) / m.roughness();
  return (exp(-x * x) / (x * sqrt(boost::math::constants::pi<Precise>())) - erfc(x)) / 2;
}
inline Precise precise_smith(const CookTorranceGgx& m, const Precise& cosine) {
  const Precise tan2 = (1 - cosine * cosine) / (cosine * cosine);
  return (sqrt(1 + m.roughness() * m.roughness() * tan2) - 1) / 2;
}
inline Precise precise_density(const CookTorranceBeckmann& m, const Precise& cos2) {
  const Precise s2 = Precise(m.roughness()) * m.roughness();
  return exp(-(1 - cos2) / cos2 / s2) / (boost::math::constants::pi<Precise>() * s2 * cos2 * cos2);
}
inline Precise precise_density(const CookTorranceGgx& m, const Precise& cos2) {
  const Precise s2 = Precise(m.roughness()) * m.roughness();
  const Precise q = cos2 * (s2 + (1 - cos2) / cos2);
  return s2 / (boost::math::constants::pi<Precise>() * q * q);
}

template <class Slopes>
Precise precise_f_r(const CookTorranceModel<double, Slopes>& m, const PreciseAngles& g) {
  const Precise f = m.f0() + (1 - Precise(m.f0())) * pow(1 - g.cos_gamma, 5);
  const Precise shadowing = 1 / (1 + precise_smith(m, g.cos_i) + precise_smith(m, g.cos_r));
  return m.kd() / boost::math::constants::pi<Precise>() +
         m.ks() * f * precise_density(m, g.cos_alpha * g.cos_alpha) * shadowing / (4 * g.cos_i * g.cos_r);
}

}  // namespace lrcs
