#include "brdf/shadowing.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lrcs {
namespace {

TEST(Shadowing, IsTheClosedFormAtRetroReflection) {
  const WuParameters<double> p{
      .kb = 0.1, .kr = 1.5, .b = -10.0, .a = 0.9, .kd = 0.02, .sigma_p = 0.7, .sigma_r = 0.1, .u_p = 15.0, .v_p = 4.0};
  for (const double theta : {0.1, 0.6, 1.2}) {
    const double w = p.sigma_p * (1.0 + p.u_p * std::sin(theta) / (std::sin(theta) + p.v_p * std::cos(theta)));
    const double g = 1.0 / (1.0 + w * std::tan(theta) * std::tan(theta));
    EXPECT_NEAR(shadowing_angles(Wu(p), theta, theta, 0.0).value(), g, 1e-12) << theta;
  }
}

TEST(Shadowing, IsNothingOfAModelWithoutOne) {
  EXPECT_FALSE(shadowing_angles(Lambert(0.5), 0.1, 0.2, 0.3).has_value());
}

TEST(Shadowing, IsZeroBelowTheSurface) {
  EXPECT_EQ(
      shadowing_angles(Wu(WuParameters<double>{.kb = 0.1, .kr = 1.0, .b = -10.0, .a = 0.9, .kd = 0.02}), 0.1, 2.0, 0.0),
      0.0);
}

}  // namespace
}  // namespace lrcs
