#include <gtest/gtest.h>

#include "tests/brdf/precise_forms.h"
#include "tests/brdf/random_parameters.h"

namespace lrcs {
namespace {

template <class Form>
class EveryFormInHighPrecision : public testing::Test {};
TYPED_TEST_SUITE(EveryFormInHighPrecision, EveryForm);

TYPED_TEST(EveryFormInHighPrecision, IsTheSameToTwelveDigits) {
  RandomDirections random(41);
  for (int k = 0; k < 3000; ++k) {
    const auto model = TypeParam::make(random_parameters<TypeParam>(random), k % 2 == 0 ? 180 : 0);
    const Vec3 n = random.on_sphere();
    const Vec3 wi = random.above(n, 1.5);
    const Vec3 wr = random.above(n, 1.5);
    const PreciseAngles angles(wi, wr, n);
    const auto expected = static_cast<double>(Precise(precise_f_r(model, angles) * angles.cos_i * angles.cos_r));
    // The rounding of a direction, 1e-16, may move a narrow lobe by more than its twelfth digit.
    const double tolerance = 1e-12 * expected + lobe_error(model, wi, wr, n);
    EXPECT_NEAR(model.f_cos_cos(wi, wr, n), expected, tolerance) << TypeParam::name;
  }
}

TEST(CookTorrance, HasMirrorsWhoseProjectedAreaIsThatOfTheSurface) {
  for (const double s : {0.05, 0.3, 1.0, 3.0}) {
    const auto area = [&](auto slopes) {
      const int rows = 200000;
      double sum = 0.0;
      for (int k = 0; k < rows; ++k) {
        const double alpha = (k + 0.5) * std::numbers::pi / 2.0 / rows;
        const double c2 = std::cos(alpha) * std::cos(alpha);
        const double s2 = std::sin(alpha) * std::sin(alpha);
        sum += decltype(slopes)::lobe(s, c2, s2) / (std::numbers::pi * s * s) * std::sqrt(c2 * s2);
      }
      return sum * std::numbers::pi * std::numbers::pi / rows;
    };
    EXPECT_NEAR(area(Beckmann()), 1.0, 1e-7) << s;
    EXPECT_NEAR(area(Ggx()), 1.0, 1e-7) << s;
  }
}

TEST(LobedModels, RefuseParametersOutsideTheirDomain) {
  EXPECT_THROW(Steinvall(-1.0, 0.1, 0.2, 1.0), ParameterError);
  EXPECT_THROW(Steinvall(1.0, 0.1, 0.0, 1.0), ParameterError);
  EXPECT_THROW(Steinvall(1.0, 0.1, 0.2, -1.0), ParameterError);
  EXPECT_THROW(Steinvall(1.0, std::nan(""), 0.2, 1.0), ParameterError);
  EXPECT_THROW(Phong(0.1, 0.1, 0.5), ParameterError);
  EXPECT_THROW(Phong(0.1, HUGE_VAL, 2.0), ParameterError);
  EXPECT_THROW(CookTorranceGgx(0.1, 0.1, 1.1, 0.2), ParameterError);
  EXPECT_THROW(CookTorranceBeckmann(0.1, 0.1, 0.5, 101.0), ParameterError);
}

TEST(Steinvall, IsThePublishedFormWhenMonostatic) {
  const Steinvall model(0.7, 0.2, 0.3, 1.4);
  for (const double theta : {0.0, 0.2, 0.7, 1.3}) {
    const double c = std::cos(theta);
    const double t = std::tan(theta);
    const double published = 0.7 * std::exp(-t * t / 0.09) / std::pow(c, 6.0) + 0.2 * std::pow(c, 1.4);
    EXPECT_NEAR(f_r_angles(model, theta, theta, 0.0), published, 1e-12 * published);
  }
}

}  // namespace
}  // namespace lrcs
