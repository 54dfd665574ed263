#include "brdf/albedo.h"

#include <gtest/gtest.h>

#include "tests/brdf/sample_brdfs.h"

namespace lrcs {
namespace {

TEST(Albedo, OfLambertIsTheReflectanceFromEveryDirection) {
  for (const double theta : {0.0, 0.4, 1.2, 1.57}) {
    const Estimate a = albedo(Lambert(0.8), theta);
    EXPECT_NEAR(a.value, 0.8, a.bound);
    EXPECT_LT(a.bound, 1e-10);
  }
}

TEST(Albedo, OfAPureDiffuseWuSurfaceIsPiKdOverTheCosine) {
  const Wu model({.kb = 0.0, .kr = 1.0, .b = 0.0, .a = 1.0, .kd = 0.05});
  for (const double theta : {0.0, 0.7, 1.5}) {
    const Estimate a = albedo(model, theta);
    EXPECT_NEAR(a.value, 0.05 * std::numbers::pi / std::cos(theta), a.bound);
  }
}

// Midpoint rule on a fixed grid: another route, good to three digits.
double by_midpoints(const Brdf& brdf, double theta_i) {
  const int rows = 600;
  double sum = 0.0;
  for (int t = 0; t < rows; ++t)
    for (int p = 0; p < rows; ++p) {
      const double theta = (t + 0.5) * std::numbers::pi / (2 * rows);
      const double phi = (p + 0.5) * std::numbers::pi / rows;
      sum += f_r_angles(brdf, theta_i, theta, phi) * std::cos(theta) * std::sin(theta);
    }
  return sum * std::numbers::pi * std::numbers::pi / (static_cast<double>(rows) * rows);
}

TEST(Albedo, MeetsTheAccuracyAskedForAndItsBoundsHold) {
  for (const Brdf& brdf : sample_brdfs())
    for (const double theta : {0.0, 0.1, 0.35, 0.6, 0.8, 1.0, 1.2, 1.4, 1.55}) {
      const Estimate rough = albedo(brdf, theta, 1e-3);
      if (std::holds_alternative<Tabulated>(brdf)) {  // its kinks want more cells than there may be
        EXPECT_NEAR(rough.value, albedo(brdf, theta, 1e-4).value, 2e-3 * rough.value);
        continue;
      }
      const Estimate fine = albedo(brdf, theta, 1e-7);
      EXPECT_LE(rough.bound, 1e-3 * rough.value);
      EXPECT_LE(fine.bound, 1e-6 * fine.value);
      EXPECT_NEAR(rough.value, fine.value, rough.bound + fine.bound);
    }
}

TEST(Albedo, AgreesWithAFixedGrid) {
  for (const Material& material : material_library())
    EXPECT_NEAR(albedo(material.brdf, 0.6).value, by_midpoints(material.brdf, 0.6), 1e-5) << material.name;
}

TEST(Albedo, RefusesAnglesThatAreNotAboveTheSurface) {
  for (const double wrong : {-0.1, std::numbers::pi / 2.0, std::nan("")})
    EXPECT_THROW(static_cast<void>(albedo(Lambert(1.0), wrong)), std::domain_error);
  EXPECT_THROW(static_cast<void>(albedo(Lambert(1.0), 0.1, 0.0)), std::domain_error);
}

}  // namespace
}  // namespace lrcs
