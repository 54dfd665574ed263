#include "brdf/tabulated.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "tests/brdf/made_measurement.h"
#include "tests/brdf/sample_brdfs.h"

namespace lrcs {
namespace {

using testing::HasSubstr;

using std::numbers::pi;

// Smooth, and reciprocal.
Brdf smooth() {
  return Steinvall(0.4, 0.1, 0.5, 1.5);
}

std::string complaint(const Tabulated& table, double theta_i, double theta_r, double phi) {
  try {
    return "value " + std::to_string(f_r_angles(table, theta_i, theta_r, phi));
  } catch (const NotMeasured& error) {
    return error.what();
  }
}

TEST(Tabulated, GivesEverySampleBack) {
  const BrdfMeasurement measurement = measured_on_grid(smooth(), 5.0, 85.0);
  const Tabulated table(measurement);
  EXPECT_EQ(table.samples(), measurement.samples.size());
  EXPECT_EQ(table.dimension(), 3);
  for (const BrdfSample& s : measurement.samples)
    EXPECT_NEAR(f_r_angles(table, s.theta_i, s.theta_r, s.phi), s.f_r, 1e-12 * s.f_r);
}

TEST(Tabulated, IsExactForWhatIsLinearInTheCoordinates) {
  const auto linear = [](const Vec3& place) { return 3.0 + place.dot(Vec3(0.3, 0.2, -0.4)); };
  BrdfMeasurement measurement = measured_on_grid(smooth(), 6.0, 84.0);
  for (BrdfSample& s : measurement.samples) s.f_r = linear(place_of_angles(s.theta_i, s.theta_r, s.phi));
  const Tabulated table(measurement);
  RandomDirections random(61);
  for (int k = 0; k < 3000; ++k) {
    const double i = random.uniform(0.0, 1.1), r = random.uniform(0.0, 1.1), phi = random.uniform(-pi, pi);
    EXPECT_NEAR(f_r_angles(table, i, r, phi), linear(place_of_angles(i, r, phi)), 1e-11);
  }
}

double rms_error(const Brdf& brdf, double step_deg) {
  const Tabulated table(measured_on_grid(brdf, step_deg, 80.0));
  RandomDirections random(62);
  double sum = 0.0;
  constexpr int count = 4000;
  for (int k = 0; k < count; ++k) {
    const double i = random.uniform(0.0, 1.2), r = random.uniform(0.0, 1.2), phi = random.uniform(0.0, pi);
    sum += std::pow(f_r_angles(table, i, r, phi) - f_r_angles(brdf, i, r, phi), 2);
  }
  return std::sqrt(sum / count);
}

TEST(Tabulated, ConvergesAtSecondOrderToASmoothBrdf) {
  const double coarse = rms_error(smooth(), 8.0), middle = rms_error(smooth(), 4.0), fine = rms_error(smooth(), 2.0);
  EXPECT_GT(std::log2(coarse / middle), 1.7);
  EXPECT_GT(std::log2(middle / fine), 1.7);
  EXPECT_LT(fine, 2e-2 * f_r_angles(smooth(), 0.0, 0.0, 0.0));
}

TEST(Tabulated, IsReciprocalToTheLastBit) {
  const Tabulated table(measured_on_grid(smooth(), 10.0, 80.0), Outside::nearest);
  RandomDirections random(63);
  for (int k = 0; k < 3000; ++k) {
    const Vec3 n = random.on_sphere(), wi = random.above(n, 1.57), wr = random.above(n, 1.57);
    EXPECT_EQ(table.f_cos_cos(wi, wr, n), table.f_cos_cos(wr, wi, n));
  }
}

// A bell of the angle from a direction: half its height at 3 deg.
double bell(double angle) {
  return std::exp2(-std::pow(angle / (3.0 * degree), 2));
}

double specular_bell(double theta_i, double theta_r, double phi) {
  const Vec3 h = from_angles(theta_i, 0.0) + from_angles(theta_r, phi);
  return bell(std::atan2(std::hypot(h.x(), h.y()), h.z()));
}

double retro_bell(double theta_i, double theta_r, double phi) {
  return bell(std::asin(0.5 * (from_angles(theta_i, 0.0) - from_angles(theta_r, phi)).norm()));
}

using Bell = double (*)(double theta_i, double theta_r, double phi);

// Measured about the peak, from incidences 15 deg apart.
BrdfMeasurement measured_bell(Bell f, double peak_phi) {
  std::vector<BrdfSample> samples;
  for (const double i : {15.0, 30.0, 45.0, 60.0})
    for (double dr = -20.0; dr <= 20.0; dr += 0.5)
      for (double across = -20.0; across <= 20.0; across += 0.5) {
        BrdfSample s{i * degree, (i + dr) * degree, peak_phi + across * degree / std::sin(i * degree), 0.0, 1.0, 0};
        if (s.theta_r < 0.0) continue;
        s.f_r = f(s.theta_i, s.theta_r, s.phi);
        samples.push_back(s);
      }
  return measurement_of(std::move(samples));
}

// In the plane of incidence and across it.
void expect_bell_between(Bell f, double peak_phi) {
  const Tabulated table(measured_bell(f, peak_phi));
  for (const double theta_deg : {20.0, 22.5, 27.0, 37.5, 50.0})
    for (double off_deg = -8.0; off_deg <= 8.0; off_deg += 0.25) {
      const double theta = theta_deg * degree, off = off_deg * degree, across = peak_phi + off / std::sin(theta);
      EXPECT_NEAR(f_r_angles(table, theta, theta + off, peak_phi), f(theta, theta + off, peak_phi), 0.04)
          << theta_deg << " " << off_deg;
      EXPECT_NEAR(f_r_angles(table, theta, theta, across), f(theta, theta, across), 0.04)
          << theta_deg << " " << off_deg;
    }
}

TEST(Tabulated, KeepsASpecularLobeAtSpecularBetweenMeasuredIncidences) {
  expect_bell_between(specular_bell, pi);
}

TEST(Tabulated, KeepsARetroLobeAtRetroBetweenMeasuredIncidences) {
  expect_bell_between(retro_bell, 0.0);
}

TEST(Tabulated, DoesNotDependOnPhiAtTheSpecularDirection) {
  const Tabulated table(measured_on_grid(smooth(), 7.0, 84.0));
  for (const double theta : {0.1, 0.5, 1.0}) {
    const double specular = f_r_angles(table, theta, theta, pi);
    for (const double aside : {1e-6, 1e-9})
      for (const double turn : {0.0, 1.0, 2.0, 3.0}) {
        const double r = theta + aside * std::cos(turn), phi = pi + aside * std::sin(turn);
        EXPECT_NEAR(f_r_angles(table, theta, r, phi), specular, 10.0 * aside);
      }
  }
}

TEST(Tabulated, KnowsWhatWasMeasuredAllAroundButNotExactly) {
  // No sample at retro, at specular, in the plane of incidence, or across it.
  const Tabulated table(measured(smooth(), steps(3.0, 80.0, 5.5), steps(1.0, 80.0, 5.0), steps(4.0, 176.0, 8.6)));
  for (const double theta : {0.2, 0.6})
    for (const double phi : {0.0, pi / 2.0, pi})
      EXPECT_NEAR(f_r_angles(table, theta, theta, phi), f_r_angles(smooth(), theta, theta, phi),
                  0.1 * f_r_angles(smooth(), theta, theta, phi));
}

TEST(Tabulated, FollowsItsRuleOutsideWhatWasMeasured) {
  const BrdfMeasurement measurement = measured_on_grid(Lambert(0.8), 10.0, 50.0);
  const Tabulated strict(measurement);
  EXPECT_EQ(
      complaint(strict, 40 * degree, 80 * degree, 30 * degree),
      "made.csv: f_r was not measured at theta_i = 40, theta_r = 80, phi = 30 deg (phi = 0: retro; nor with the "
      "directions exchanged): expected samples about there, or outside: nearest or outside: zero in the material");
  EXPECT_THAT(complaint(strict, 40 * degree, 50 * degree, pi), HasSubstr("value"));
  EXPECT_THROW(static_cast<void>(strict.f_cos_cos_retro(std::cos(1.2))), NotMeasured);
  EXPECT_EQ(f_r_angles(strict.with(Outside::zero), 40 * degree, 80 * degree, 0.5), 0.0);
  EXPECT_NEAR(f_r_angles(strict.with(Outside::nearest), 40 * degree, 80 * degree, 0.5), 0.8 / pi, 1e-15);
}

TEST(Tabulated, DoesNotComplainOfDirectionsThatRoundingMayMakeOfFacetsSeenEdgeOn) {
  const Tabulated table(measured_on_grid(Lambert(0.8), 10.0, 50.0));
  const double tiny = 0x1p-44;
  EXPECT_NEAR(table.f_cos_cos_retro(tiny), 0.8 / pi * tiny * tiny, 1e-40);
  EXPECT_GE(table.f_cos_cos(Vec3(1.0, 0.0, tiny), Vec3(0.0, 0.6, 0.8), Vec3(0.0, 0.0, 1.0)), 0.0);
}

TEST(Tabulated, TakesTheMeanByWeightOfWhatWasMeasuredTwice) {
  BrdfMeasurement measurement = measured_on_grid(Lambert(0.5), 10.0, 80.0);
  const auto add = [&](double i, double r, double phi, double f_r, double weight) {
    measurement.samples.push_back({i * degree, r * degree, phi * degree, f_r, weight, 0});
  };
  add(33.0, 44.0, 55.0, 1.0, 1.0);
  add(44.0, 33.0, 55.0, 4.0, 1.0);   // exchanged
  add(33.0, 44.0, -55.0, 4.0, 1.0);  // in a mirror
  add(33.0, 44.0, 55.0, 1e6, 0.0);   // does not count
  const Tabulated table(measurement);
  EXPECT_NEAR(f_r_angles(table, 33 * degree, 44 * degree, 55 * degree), 3.0, 1e-12);
  EXPECT_EQ(table.samples(), measurement.samples.size() - 1);
  EXPECT_EQ(table.largest(), 3.0);
  EXPECT_THAT(table.measurement().warnings, testing::ElementsAre(HasSubstr("measured more than once")));
}

TEST(Tabulated, OfOnePlaneKnowsThatPlane) {
  const Tabulated table(measured(smooth(), steps(0.0, 60.0, 5.0), steps(0.0, 80.0, 2.0), {0.0, 180.0}));
  EXPECT_EQ(table.dimension(), 2);
  for (const double phi : {0.0, pi})
    EXPECT_NEAR(f_r_angles(table, 0.41, 0.7, phi), f_r_angles(smooth(), 0.41, 0.7, phi),
                0.02 * f_r_angles(smooth(), 0.41, 0.7, phi));
  EXPECT_THAT(complaint(table, 0.41, 0.7, 0.1), HasSubstr("; the samples fill a plane"));
  EXPECT_GT(f_r_angles(table.with(Outside::nearest), 0.41, 0.7, 0.1), 0.0);
}

TEST(Tabulated, OfRetroReflectionAloneServesMonostaticSweeps) {
  std::vector<BrdfSample> samples;
  for (const double deg : {0.0, 20.0, 40.0, 60.0}) samples.push_back({deg * degree, deg * degree, 0.0, deg, 1.0, 0});
  const Tabulated table(measurement_of(samples));
  EXPECT_EQ(table.dimension(), 1);
  const double cosine = std::cos(30.0 * degree);
  EXPECT_NEAR(table.f_cos_cos_retro(cosine), 30.0 * cosine * cosine, 1e-12);
  EXPECT_THROW(static_cast<void>(f_r_angles(table, 0.5, 0.6, 0.0)), NotMeasured);
}

TEST(Tabulated, OfOneSampleKnowsOnePlace) {
  const Tabulated table(measurement_of({{0.5, 0.5, pi, 2.0, 1.0, 0}}));
  EXPECT_EQ(table.dimension(), 0);
  EXPECT_NEAR(f_r_angles(table, 0.5, 0.5, pi), 2.0, 1e-15);
  EXPECT_THROW(static_cast<void>(f_r_angles(table, 0.5, 0.6, pi)), NotMeasured);
}

TEST(Tabulated, WarnsWhereGapsMakeRetroReflectionAGuess) {
  const Brdf lobe = CookTorranceGgx(0.1, 0.8, 0.3, 0.1);
  const auto zeniths = steps(0.0, 80.0, 4.0);
  const auto azimuths = steps(0.0, 180.0, 10.0);
  const auto warnings = [&](const std::vector<double>& incidences) {
    return Tabulated(measured(lobe, incidences, zeniths, azimuths)).measurement().warnings;
  };
  ASSERT_EQ(warnings({0.0, 60.0}).size(), 1U);
  EXPECT_THAT(warnings({0.0, 60.0})[0], HasSubstr("a monostatic result there is a guess"));
  EXPECT_TRUE(Tabulated(measured_on_grid(smooth(), 5.0, 85.0)).measurement().warnings.empty());
}

TEST(Tabulated, RefusesNoSamplesAndTooMany) {
  EXPECT_THROW(Tabulated{measurement_of({})}, InputError);
  EXPECT_THROW(Tabulated{measurement_of({{0.5, 0.5, 0.0, 2.0, 0.0, 0}})}, InputError);
  EXPECT_THROW(Tabulated{measurement_of(std::vector<BrdfSample>(Tabulated::most_samples + 1))}, InputError);
}

TEST(Tabulated, GivesTheSameBytesOnManyThreads) {
  const Tabulated table(measured_on_grid(smooth(), 6.0, 72.0), Outside::nearest);
  const auto all = [&](unsigned turn) {
    std::vector<double> values(20000);
    for (std::size_t k = 0; k < values.size(); ++k) {
      const std::size_t at = (k * 7919 + turn * 131) % values.size();
      RandomDirections random(static_cast<unsigned>(at));
      const Vec3 n = Vec3::UnitZ();
      values[at] = table.f_cos_cos(random.above(n, 1.5), random.above(n, 1.5), n);
    }
    return values;
  };
  const auto alone = all(0);
  std::vector<std::vector<double>> together(4);
  std::vector<std::thread> threads;
  for (unsigned t = 0; t < 4; ++t) threads.emplace_back([&, t] { together[t] = all(t); });
  for (auto& thread : threads) thread.join();
  for (const auto& values : together) EXPECT_EQ(values, alone);
}

}  // namespace
}  // namespace lrcs
