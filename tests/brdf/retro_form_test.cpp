#include "brdf/retro_form.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "brdf/library.h"

namespace lrcs {
namespace {

constexpr double u = 0x1p-53;

void expect_retro(const Wu& wu, double cosine) {
  const auto form = retro_form(wu);
  ASSERT_TRUE(form);
  const long double c = cosine;
  EXPECT_NEAR((*form)(cosine), static_cast<double>(wu.f_cos_cos_retro(c) / c), 16.0 * u * (*form)(cosine)) << cosine;
}

TEST(RetroForm, IsTheRetroReflectionOverTheCosine) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(-44.0, 0.0), any(0.0, 1.0);
  for (const Material& m : material_library())
    for (int k = 0; k < 1000; ++k) {
      expect_retro(std::get<Wu>(m.brdf), std::exp2(exponent(random)));
      expect_retro(std::get<Wu>(m.brdf), any(random));
      expect_retro(std::get<Wu>(m.brdf), 1.0 - 0.1 * std::exp2(exponent(random)));
    }
  expect_retro(std::get<Wu>(material_library()[0].brdf), 1.0);
  const auto lambert = retro_form(Lambert(0.6));
  ASSERT_TRUE(lambert);
  EXPECT_NEAR((*lambert)(0.3), Lambert(0.6).f_cos_cos_retro(0.3) / 0.3, 4.0 * u);
}

TEST(RetroForm, IsRightForParametersOfAnyModerateSize) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> exponent(-99.0, 99.0), any(0.0, 1.0);
  for (int k = 0; k < 3000; ++k) {
    WuParameters<double> p;
    for (double* x : {&p.kb, &p.kr, &p.kd, &p.sigma_p, &p.u_p, &p.v_p}) *x = std::exp2(exponent(random));
    if (k % 5 == 0) p.sigma_p = 0.0;
    if (k % 7 == 0) p.kd = 0.0;
    p.b = -1.0, p.a = 1.0;
    expect_retro(Wu(p), any(random));
    expect_retro(Wu(p), smallest_retro_cosine);
  }
}

TEST(RetroForm, IsNotThereWhereItWouldNotHold) {
  WuParameters<double> p = std::get<Wu>(material_library()[0].brdf).parameters();
  p.azimuth_of_specular = 0;
  EXPECT_FALSE(retro_form(Wu(p)));
  p.azimuth_of_specular = 180;
  p.kr = 1e-200;
  EXPECT_FALSE(retro_form(Wu(p)));
}

}  // namespace
}  // namespace lrcs
