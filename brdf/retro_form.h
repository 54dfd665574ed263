#pragma once
#include <cmath>
#include <optional>

#include "brdf/lambert.h"
#include "brdf/wu.h"

namespace lrcs {

// f_cos_cos_retro() of a model (brdf/brdf.h), divided by the cosine, as a function without branches: for loops over
// many facets that the compiler turns into vector code.
// value: f_r cos theta [1/sr]. domain: cosine in [smallest_retro_cosine, 1].
// error: 16 u relative, u = 2^-53, for the cosine given. check: against f_cos_cos_retro() in
// tests/brdf/retro_form_test.cpp.
inline constexpr double smallest_retro_cosine = 0x1p-44;

// Of what returns nothing.
struct BlackRetro {
  [[nodiscard]] double operator()(double /*cosine*/) const { return 0.0; }
};

struct LambertRetro {
  double f;  // [1/sr]

  [[nodiscard]] double operator()(double cosine) const { return f * cosine; }
};

// kb P G / cos + kd with P = kr^2 cos / (1 - cos + kr^2 cos) and G = cos^2 / (cos^2 + w sin^2): one quotient in all.
// Only positive numbers are added (1 - cos is exact where it cancels).
struct WuRetro {
  double height;  // kb kr^2
  double kr2, kd;
  double sigma_p, steep;  // w = (steep sin + sigma_p v_p cos) / (sin + v_p cos), steep = sigma_p (1 + u_p)
  double v_p;

  [[nodiscard]] double operator()(double cosine) const {
    const double rest = 1.0 - cosine;
    const double sin2 = rest * (1.0 + cosine);
    const double sine = std::sqrt(sin2);
    const double along = v_p * cosine;
    const double upright = cosine * cosine * (sine + along);
    const double leaning = sin2 * (steep * sine + sigma_p * along);
    return height * upright / ((rest + kr2 * cosine) * (upright + leaning)) + kd;
  }
};

// Of a model for which no such function is written here.
template <class Model>
[[nodiscard]] std::optional<BlackRetro> retro_form(const Model& /*model*/) {
  return std::nullopt;
}

[[nodiscard]] inline std::optional<LambertRetro> retro_form(const Lambert& lambert) {
  return LambertRetro{lambert.f_cos_cos_retro(1.0)};
}

// Nothing in the mirrored convention, which is no such function, and for parameters so large or small that a step might
// overflow or vanish.
[[nodiscard]] inline std::optional<WuRetro> retro_form(const Wu& wu) {
  const auto& p = wu.parameters();
  const auto moderate = [](double x) { return x == 0.0 || (x >= 0x1p-100 && x <= 0x1p100); };
  for (const double x : {p.kb, p.kr, p.kd, p.sigma_p, p.u_p, p.v_p})
    if (!moderate(x)) return std::nullopt;
  if (p.azimuth_of_specular == 0) return std::nullopt;
  const double kr2 = p.kr * p.kr;
  return WuRetro{p.kb * kr2, kr2, p.kd, p.sigma_p, p.sigma_p * (1.0 + p.u_p), p.v_p};
}

}  // namespace lrcs
