#include "brdf/wu.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "tests/brdf/angle_form.h"
#include "tests/brdf/sample_brdfs.h"

namespace lrcs {
namespace {

using std::numbers::pi;

const WuParameters<double>& published(std::string_view name) {
  return std::get<Wu>(find_in_library(name)->brdf).parameters();
}

WuParameters<double> mirrored(WuParameters<double> p) {
  p.azimuth_of_specular = 180 - p.azimuth_of_specular;
  return p;
}

struct Reference {
  const char* set;
  double theta_i, theta_r, phi, f_r;  // [deg], [1/sr]
};
// f_r by the angle form in 30-digit arithmetic, rounded to 16 digits.
constexpr Reference references[] = {
    {"metal-skin-5p", 30, 30, 0, 0.1200651534427119},          {"metal-skin-5p", 30, 20, 90, 0.07835618033328178},
    {"metal-skin-5p", 50, 70, 120, 0.07935107864810252},       {"metal-skin-5p", 60, 45, 30, 0.1168831680479019},
    {"metal-skin-5p", 30, 40, 180, 0.05978722823825944},       {"metal-skin-5p", 10, 10, 0, 0.1566111155895837},
    {"metal-skin-5p", 85, 85, 0, 0.5937430985624048},          {"metal-skin-5p", 89.9, 89.9, 0, 29.22101758553894},
    {"metal-skin-5p", 30, 89.99, 180, 0.0588897871261055},     {"metal-skin-5p", 89.99, 20, 60, 292.2084830497065},
    {"metal-skin-9p", 30, 30, 0, 0.134330995253371},           {"metal-skin-9p", 30, 20, 90, 0.0884943747147756},
    {"metal-skin-9p", 50, 70, 120, 0.07012864587595758},       {"metal-skin-9p", 60, 45, 30, 0.1084489169589083},
    {"metal-skin-9p", 30, 40, 180, 0.05461435953745735},       {"metal-skin-9p", 10, 10, 0, 0.1607022183568546},
    {"painted-steel-5p", 30, 30, 0, 0.132060561484495},        {"painted-steel-5p", 30, 20, 90, 0.02157665567539797},
    {"painted-steel-5p", 50, 70, 120, 0.02333625600504073},    {"painted-steel-5p", 60, 45, 30, 0.03719356257240065},
    {"painted-steel-5p", 30, 40, 180, 0.01736048847965774},    {"painted-steel-5p", 10, 10, 0, 0.1619470879822514},
    {"painted-steel-9p", 30, 30, 0, 0.1382266635711699},       {"painted-steel-9p", 30, 20, 90, 0.02294417793529176},
    {"painted-steel-9p", 50, 70, 120, 0.0256695779515943},     {"painted-steel-9p", 60, 45, 30, 0.03638143025397943},
    {"painted-steel-9p", 30, 40, 180, 0.01907222667867295},    {"painted-steel-9p", 10, 10, 0, 0.1827120840256315},
    {"painted-steel-9p", 85, 85, 0, 0.1932885595653832},       {"painted-steel-9p", 89.9, 89.9, 0, 9.453881679072389},
    {"painted-steel-9p", 30, 89.99, 180, 0.01905255958481794}, {"painted-steel-9p", 89.99, 20, 60, 94.53803719172798},
};

TEST(Wu, GivesTheReferenceValuesOfThePublishedSets) {
  for (const Reference& r : references) {
    const Wu model(published(r.set));
    EXPECT_NEAR(f_r_angles(model, r.theta_i * degree, r.theta_r * degree, r.phi * degree), r.f_r, 1e-12 * r.f_r)
        << r.set << " " << r.theta_i << " " << r.theta_r << " " << r.phi;
  }
}

TEST(Wu, AgreesWithTheAngleFormInRandomDirectionsAndFrames) {
  RandomDirections random(11);
  int compared = 0;
  for (const Material& material : material_library())
    for (int k = 0; k < 5000; ++k) {
      const double theta_i = random.uniform(0.0, 1.5);
      const double theta_r = random.uniform(0.0, 1.5);
      const double phi = random.uniform(0.0, 2.0 * pi);
      const WuParameters<double>& p = std::get<Wu>(material.brdf).parameters();
      const AngleForm expected(p, theta_i, theta_r, phi);
      if (expected.sin_alpha < 0.02L) continue;  // there the angle form itself cancels, and G follows every rounding
      const Eigen::AngleAxisd turn(random.uniform(0.0, 6.0), random.on_sphere());
      const Vec3 wi = turn * from_angles(theta_i, 0.0);
      const Vec3 wr = turn * from_angles(theta_r, phi);
      const Vec3 n = turn * Vec3::UnitZ();
      const auto f = static_cast<double>(expected.f_r);
      EXPECT_NEAR(f_r(material.brdf, wi, wr, n), f, 1e-12 * f);
      EXPECT_NEAR(Wu(p).shadowing(wi, wr, n), static_cast<double>(expected.shadowing), 1e-12);
      ++compared;
    }
  EXPECT_GT(compared, 18000);
}

TEST(Wu, InTheMirroredConventionIsTheAngleFormAtTheSupplementaryAzimuth) {
  RandomDirections random(12);
  for (const Material& material : material_library())
    for (int k = 0; k < 2000; ++k) {
      const double theta_i = random.uniform(0.0, 1.5);
      const double theta_r = random.uniform(0.0, 1.5);
      const double phi = random.uniform(0.0, pi);
      const WuParameters<double>& p = std::get<Wu>(material.brdf).parameters();
      const AngleForm expected(p, theta_i, theta_r, pi - phi);
      if (expected.sin_alpha < 0.02L) continue;
      const auto f = static_cast<double>(expected.f_r);
      EXPECT_NEAR(f_r_angles(Wu(mirrored(p)), theta_i, theta_r, phi), f, 1e-12 * f);
      const Vec3 wi = from_angles(theta_i, 0.3);
      const Vec3 wr = from_angles(theta_r, 0.3 + phi);
      const Vec3 turned(-wr.x(), -wr.y(), wr.z());
      EXPECT_NEAR(f_cos_cos(Wu(mirrored(p)), wi, wr, Vec3(0, 0, 1)), f_cos_cos(Wu(p), wi, turned, Vec3(0, 0, 1)),
                  1e-15);
    }
}

TEST(Wu, AtRetroReflectionDependsOnNeitherABNorSigmaR) {
  RandomDirections random(13);
  WuParameters<double> p = published("metal-skin-9p");
  const Wu one(p);
  p.a = 3.0;
  p.b = 5.0;
  p.sigma_r = 2.0;
  const Wu other(p);
  for (int k = 0; k < 1000; ++k) {
    const Vec3 n = random.on_sphere();
    const Vec3 w = random.above(n, 1.57);
    EXPECT_EQ(one.f_cos_cos(w, w, n), other.f_cos_cos(w, w, n));
  }
}

TEST(Wu, AtRetroReflectionShadowsByOneOverOnePlusWTangentSquared) {
  const WuParameters<double>& p = published("painted-steel-9p");
  for (double theta = 0.0; theta < 1.57; theta += 0.01) {
    const double w = p.sigma_p * (1.0 + p.u_p * std::sin(theta) / (std::sin(theta) + p.v_p * std::cos(theta)));
    const Vec3 direction = from_angles(theta, 0.7);
    const double g = Wu(p).shadowing(direction, direction, Vec3(0, 0, 1));
    EXPECT_NEAR(g, 1.0 / (1.0 + w * std::pow(std::tan(theta), 2)), 1e-12);
  }
}

TEST(Wu, NearRetroReflectionTendsToItsMonostaticForm) {
  const Vec3 n(0, 0, 1);
  for (const Material& material : material_library()) {
    const Wu& model = std::get<Wu>(material.brdf);
    for (const double theta : {0.2, 0.8, 1.4}) {
      const double retro = model.f_cos_cos_retro(std::cos(theta));
      double last = 1.0;
      for (double step = 1e-2; step > 1e-7; step /= 10.0) {
        const double gap = std::abs(model.f_cos_cos(from_angles(theta, 0), from_angles(theta + step, step), n) - retro);
        EXPECT_LT(gap, last);
        last = gap;
      }
      EXPECT_LT(last, 1e-6);
    }
  }
}

double in_plane_shadowing(const WuParameters<double>& p, double theta) {
  const double t = std::tan(theta);
  return (1.0 + p.sigma_p * t * t / (1.0 + p.sigma_r * t)) / std::pow(1.0 + p.sigma_p * t * t, 2);
}

TEST(Wu, AtTheSpecularDirectionTakesTheInPlaneValueInAnyFrame) {
  RandomDirections random(14);
  for (const Material& material : material_library()) {
    const Wu& model = std::get<Wu>(material.brdf);
    for (int k = 0; k < 3000; ++k) {
      const Vec3 n = random.on_sphere();
      const Vec3 wi = random.above(n, 1.5);
      const Vec3 wr = (2.0 * wi.dot(n) * n - wi).normalized();
      EXPECT_NEAR(model.shadowing(wi, wr, n), in_plane_shadowing(model.parameters(), std::acos(wi.dot(n))), 1e-10);
    }
  }
}

TEST(Wu, TendsToTheSpecularValueWithinThePlaneOfIncidence) {
  const Vec3 n(0, 0, 1);
  const WuParameters<double>& p = published("metal-skin-5p");
  for (const double theta : {0.3, 1.0, 1.4})
    for (const double step : {1e-6, -1e-6}) {
      const double g = Wu(p).shadowing(from_angles(theta, 0.0), from_angles(theta + step, pi), n);
      EXPECT_NEAR(g, in_plane_shadowing(p, theta), 1e-3);
    }
}

TEST(Wu, AtNormalIncidenceGivesKbPlusKd) {
  for (const Material& material : material_library()) {
    const auto& p = std::get<Wu>(material.brdf).parameters();
    EXPECT_DOUBLE_EQ(f_r_angles(material.brdf, 0.0, 0.0, 0.0), p.kb + p.kd);
    EXPECT_DOUBLE_EQ(f_r_angles(Wu(mirrored(p)), 0.0, 0.0, 0.0), p.kb + p.kd);
  }
}

TEST(Wu, AtGrazingLeavesOnlyTheDiffuseTermOverTheCosine) {
  for (const double deg : {89.0, 89.99, 89.9999, 89.999999}) {
    const WuParameters<double>& p = published("metal-skin-9p");
    const double cosine = std::cos(deg * degree);
    const double f_cos_cos = Wu(p).f_cos_cos(from_angles(deg * degree, 0), from_angles(deg * degree, 0), Vec3(0, 0, 1));
    EXPECT_GT(f_cos_cos, p.kd * cosine);
    EXPECT_LT(f_cos_cos, p.kd * cosine + 2.0 * cosine * cosine);
    const double across = f_r_angles(Wu(p), deg * degree, deg * degree, pi);
    EXPECT_NEAR(across * cosine, p.kd, 1e-3);
  }
}

TEST(Wu, HasOneFunctionForFiveAndNineParameters) {
  WuParameters<double> nine = published("metal-skin-5p");
  nine.sigma_p = 0.0136;
  nine.sigma_r = 0.0136;
  nine.u_p = 9.0;
  nine.v_p = 1.0;
  EXPECT_TRUE(nine.has_empirical_shadowing());
  EXPECT_FALSE(published("metal-skin-9p").has_empirical_shadowing());
  EXPECT_EQ(f_r_angles(Wu(nine), 0.4, 0.9, 1.0), f_r_angles(Wu(published("metal-skin-5p")), 0.4, 0.9, 1.0));
}

TEST(Wu, StaysFiniteWithExtremeParameters) {
  const WuParameters<double> usual = published("metal-skin-5p");
  std::vector<WuParameters<double>> extremes(10, usual);
  extremes[0].kr = 1e-320;
  extremes[1].kr = 1e300;
  extremes[2].b = 700.0;
  extremes[3].b = -1e308;
  extremes[4].a = 1e-300;
  extremes[5].a = 1e300;
  extremes[6].sigma_p = 1e300;
  extremes[7].sigma_r = 1e308;
  extremes[8].v_p = 1e-320;
  extremes[9].v_p = 1e308;
  RandomDirections random(15);
  for (const auto& p : extremes)
    for (const Wu& model : {Wu(p), Wu(mirrored(p))})
      for (int k = 0; k < 500; ++k) {
        const Vec3 n = random.on_sphere();
        const Vec3 wi = random.above(n, pi / 2.0);
        const Vec3 wr = k % 2 == 0 ? wi : random.above(n, pi / 2.0);
        for (const double value : {model.f_cos_cos(wi, wr, n), model.f_cos_cos_retro(wi.dot(n))}) {
          ASSERT_GE(value, 0.0);
          ASSERT_LE(value, model.largest() * (1.0 + 1e-12));
        }
      }
}

TEST(Wu, RefusesParametersOutsideTheirDomain) {
  const auto refused = [](double WuParameters<double>::*parameter, double value) {
    WuParameters<double> p = published("metal-skin-9p");
    p.*parameter = value;
    EXPECT_THROW(Wu{p}, ParameterError) << value;
  };
  using P = WuParameters<double>;
  for (const auto parameter : {&P::kb, &P::kd, &P::sigma_p, &P::sigma_r, &P::u_p}) refused(parameter, -1e-9);
  for (const auto parameter : {&P::kr, &P::a, &P::v_p}) refused(parameter, 0.0);
  for (const auto parameter : {&P::kb, &P::kr, &P::b, &P::a, &P::kd, &P::sigma_p, &P::sigma_r, &P::u_p, &P::v_p}) {
    refused(parameter, std::nan(""));
    refused(parameter, std::numeric_limits<double>::infinity());
    refused(parameter, -std::numeric_limits<double>::infinity());
  }
  refused(&P::b, 800.0);
  P azimuth = published("metal-skin-9p");
  azimuth.azimuth_of_specular = 90;
  EXPECT_THROW(Wu{azimuth}, ParameterError);
  P steep = published("metal-skin-9p");
  steep.sigma_p = 1e200;
  steep.u_p = 1e200;
  EXPECT_THROW(Wu{steep}, ParameterError);
}

// Along great circles of normals: over a crease the second difference goes with the step, elsewhere with its square.
TEST(Wu, TellsItsCreases) {
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal;
  const auto direction = [&] { return Vec3(Vec3(normal(random), normal(random), normal(random)).normalized()); };
  int found = 0, told = 0;
  for (const auto& p : {published("metal-skin-9p"), mirrored(published("metal-skin-9p")), published("metal-skin-5p")})
    for (int path = 0; path < 40; ++path) {
      const Vec3 wi = direction(), wr = direction(), from = (wi + wr).normalized();
      const Vec3 across = from.cross(direction()).normalized(), beside = 0.3 * direction();
      const auto n = [&](double t) { return Vec3((std::cos(t) * from + std::sin(t) * across + beside).normalized()); };
      const auto pair = Wu(p).for_pair(wi, wr);
      constexpr double step = 1e-3;
      for (double t = -1.0; t < 1.0; t += step) {
        if (std::min({n(t - step).dot(wi), n(t - step).dot(wr), n(t + step).dot(wi), n(t + step).dot(wr)}) < 0.1)
          continue;
        const auto bend = [&](double h) { return std::abs(pair(n(t + h)) - 2.0 * pair(n(t)) + pair(n(t - h))); };
        const auto before = pair.creases(n(t - step)), after = pair.creases(n(t + step));
        bool crosses = false;
        for (std::size_t k = 0; k < 3; ++k) crosses = crosses || (before[k] > 0.0) != (after[k] > 0.0);
        const bool is_crease = bend(step) > 3e-6 && bend(step) < 3.0 * bend(0.5 * step);
        told += crosses ? 1 : 0;
        found += is_crease && crosses ? 1 : 0;
        EXPECT_TRUE(!is_crease || crosses) << path << ", " << t << ": " << bend(step) << " " << bend(0.5 * step);
      }
    }
  EXPECT_GT(found, 20);
  EXPECT_LT(told, 40 * found);
}

TEST(Wu, NamesTheParameterThatIsWrong) {
  WuParameters<double> p = published("metal-skin-9p");
  p.kb = -1.0;
  try {
    const Wu model(p);
    FAIL() << model.largest();
  } catch (const ParameterError& error) {
    EXPECT_EQ(error.parameter(), "kb");
    EXPECT_STREQ(error.what(), "expected kb >= 0, found -1");
  }
}

}  // namespace
}  // namespace lrcs
