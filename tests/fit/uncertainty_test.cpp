#include "fit/uncertainty.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <random>

#include "fit/descent.h"
#include "fit/search.h"
#include "tests/fit/goniometer_data.h"
#include "tests/fit/linear_problem.h"

namespace lrcs {
namespace {

TEST(Uncertainty, OfAMeanIsTheTextbooks) {
  std::mt19937 engine(14);
  std::normal_distribution<double> z;
  constexpr Eigen::Index n = 12;
  Eigen::VectorXd t(n);
  for (double& x : t) x = 5.0 + 0.3 * z(engine);
  const double mean = t.mean();
  const double s = std::sqrt((t.array() - mean).square().sum() / (n - 1));
  const LinearProblem problem(Eigen::MatrixXd::Ones(n, 1), t, {{-100.0, 100.0}});
  const auto error = uncertainty(problem, {mean}).parameters[0];
  EXPECT_TRUE(error.determined) << error.why_not;
  EXPECT_NEAR(error.standard_error, s / std::sqrt(n), 1e-6 * s);
  const double t95 = boost::math::quantile(boost::math::students_t(n - 1), 0.975);
  EXPECT_NEAR(error.half_width, t95 * s / std::sqrt(n), 1e-6 * s);
}

TEST(Uncertainty, OfAStraightLineHasItsCorrelation) {
  constexpr Eigen::Index n = 40;
  std::mt19937 engine(15);
  std::normal_distribution<double> z;
  Eigen::MatrixXd a(n, 2);
  Eigen::VectorXd t(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    a.row(k) << 1.0, static_cast<double>(k);
    t[k] = 30.0 + 2.0 * static_cast<double>(k) + z(engine);
  }
  const Eigen::Matrix2d inverse = (a.transpose() * a).inverse();
  const Eigen::Vector2d x = inverse * a.transpose() * t;
  const double variance = (a * x - t).squaredNorm() / (n - 2);
  const Uncertainty told = uncertainty(LinearProblem(a, t, {{-1e3, 1e3}, {-1e3, 1e3}}), {x[0], x[1]});
  // Leverages differ: the mean of r^2/(1 - h) is not quite s^2.
  for (Eigen::Index k = 0; k < 2; ++k)
    EXPECT_NEAR(told.parameters[static_cast<std::size_t>(k)].standard_error / std::sqrt(variance * inverse(k, k)), 1.0,
                0.02);
  EXPECT_NEAR(told.correlation(0, 1), inverse(0, 1) / std::sqrt(inverse(0, 0) * inverse(1, 1)), 1e-9);
}

// f_r cos_r with noise of one variance: the standard error of the reflectance is pi sigma/sqrt(sum cos_r^2). Its mean
// over 200 repetitions of 164 samples is known to 1 %.
TEST(Uncertainty, OfLambertsReflectanceIsTheTextbooks) {
  constexpr double sigma = 0.01;
  std::mt19937 engine(16);
  std::normal_distribution<double> z;
  double squares = 0.0, mean = 0.0;
  for (const BrdfSample& s : goniometer_samples(Lambert(0.5))) squares += std::pow(std::cos(s.theta_r), 2.0);
  constexpr int repetitions = 200;
  for (int repeat = 0; repeat < repetitions; ++repeat) {
    auto samples = goniometer_samples(Lambert(0.5));
    for (BrdfSample& s : samples) s.f_r = std::max(s.f_r + sigma * z(engine) / std::cos(s.theta_r), 0.0);
    const auto problem = fit_problem("lambert", 180, samples, Residual::linear);
    std::vector<double> value(1);
    problem->solve_linear(value);
    mean += uncertainty(*problem, value).parameters[0].standard_error / repetitions;
  }
  EXPECT_NEAR(mean / (std::numbers::pi * sigma / std::sqrt(squares)), 1.0, 0.05);
}

// Every second sample ten times noisier with a hundredth of the weight, as 1/variance is; noise as the root of the
// value, as counted photons have. The mean standard error is what the values spread, within what 200 repetitions tell
// (5 %) and the kinds of noise cannot be told apart.
TEST(Uncertainty, IsThatOfTheKindOfNoise) {
  constexpr int repetitions = 200;
  const auto truth = truth_of(published("metal-skin-5p"));
  enum class Noise { by_weight, counted };
  for (const Noise noise : {Noise::by_weight, Noise::counted}) {
    std::mt19937 engine(21);
    std::normal_distribution<double> z;
    std::array<double, 5> sum{}, squares{}, errors{};
    for (int repeat = 0; repeat < repetitions; ++repeat) {
      auto samples = goniometer_samples(published("metal-skin-5p"));
      for (std::size_t k = 0; k < samples.size(); ++k) {
        BrdfSample& s = samples[k];
        const double value = s.f_r * std::cos(s.theta_r);
        const double ratio = k % 2 == 0 ? 1.0 : 10.0;
        double sigma = 0.003 * std::sqrt(value);
        if (noise == Noise::by_weight) {
          sigma = 0.0003 * ratio;
          s.weight = 1.0 / (ratio * ratio);
        }
        s.f_r = std::max(s.f_r + sigma * z(engine) / std::cos(s.theta_r), 0.0);
      }
      const auto problem = fit_problem("five_parameter", 180, samples, Residual::linear);
      const auto found = descend(*problem, truth, {}).parameters;
      const Uncertainty told = uncertainty(*problem, found);
      for (std::size_t k = 0; k < 5; ++k) {
        sum[k] += found[k] - truth[k];
        squares[k] += std::pow(found[k] - truth[k], 2.0);
        errors[k] += told.parameters[k].standard_error;
      }
    }
    for (std::size_t k = 0; k < 5; ++k) {
      const double spread = std::sqrt((squares[k] - sum[k] * sum[k] / repetitions) / (repetitions - 1));
      EXPECT_NEAR(errors[k] / repetitions / spread, 1.0, 0.2) << k;
    }
  }
}

// 300 trials at a chance of 95 % have a standard deviation of 1.3 %: 90 and 98 % are 4 and 2.4 of them away.
TEST(Uncertainty, HasIntervalsThatCoverTheTruth) {
  constexpr int repetitions = 300;
  for (const char* name : {"metal-skin-5p", "painted-steel-5p"}) {
    const auto truth = truth_of(published(name));
    std::array<int, 5> determined{}, covered{};
    for (unsigned seed = 1; seed <= repetitions; ++seed) {
      const auto problem =
          fit_problem("five_parameter", 180, goniometer_samples(published(name), 0.03, seed + 1000), Residual::linear);
      const auto found = descend(*problem, truth, {}).parameters;
      const Uncertainty told = uncertainty(*problem, found);
      for (std::size_t k = 0; k < 5; ++k) {
        if (!told.parameters[k].determined) continue;
        ++determined[k];
        if (std::abs(found[k] - truth[k]) <= told.parameters[k].half_width) ++covered[k];
      }
    }
    for (std::size_t k = 0; k < 5; ++k) {
      ASSERT_GE(determined[k], repetitions / 2) << name << " " << k;
      const double share = static_cast<double>(covered[k]) / determined[k];
      EXPECT_GE(share, 0.90) << name << " " << k;
      EXPECT_LE(share, 0.98) << name << " " << k;
    }
  }
}

TEST(Uncertainty, NamesWhatNineParametersAreNotToldByData) {
  const auto truth = truth_of(published("metal-skin-9p"));
  constexpr int repetitions = 20;
  std::array<int, 9> determined{};
  for (unsigned seed = 1; seed <= repetitions; ++seed) {
    const auto problem = fit_problem("nine_parameter", 180, goniometer_samples(published("metal-skin-9p"), 0.03, seed),
                                     Residual::linear);
    const Uncertainty told = uncertainty(*problem, descend(*problem, truth, {}).parameters);
    for (std::size_t k = 0; k < 9; ++k) {
      EXPECT_EQ(told.parameters[k].determined, told.parameters[k].why_not.empty());
      if (told.parameters[k].determined) ++determined[k];
    }
  }
  for (const std::size_t k : {0U, 3U, 4U}) EXPECT_GE(determined[k], 15) << k;  // kb, a, kd
  for (const std::size_t k : {6U, 8U}) EXPECT_LE(determined[k], 5) << k;       // sigma_r, v_p
}

// Where u_p ends at 0 or at the most, kr looks sharp; the truth, with all shadowing constants inside their ranges, is
// another valley. In one set of data in fifteen the interval misses the truth unless that valley is looked into.
TEST(Uncertainty, LooksIntoOtherValleys) {
  const auto& material = published("metal-skin-5p");
  auto truth = truth_of(material);
  const WuParameters<double> empirical;
  truth.insert(truth.end(), {empirical.sigma_p, empirical.sigma_r, empirical.u_p, empirical.v_p});
  constexpr std::size_t kr = 1;
  int missed_alone = 0, missed = 0;
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const auto problem = fit_problem("nine_parameter", 180, goniometer_samples(material, 0.01, seed), Residual::linear);
    const Found found = search(*problem, {}, {truth});
    const auto misses = [&](const ParameterError95& e) {
      return e.determined && std::abs(found.parameters[kr] - truth[kr]) > e.half_width;
    };
    missed_alone += misses(uncertainty(*problem, found.parameters).parameters[kr]) ? 1 : 0;
    missed += misses(uncertainty(*problem, found.parameters, found.rivals).parameters[kr]) ? 1 : 0;
  }
  EXPECT_GE(missed_alone, 2);
  EXPECT_EQ(missed, 0);
}

TEST(Uncertainty, OfAParameterAtTheEndOfItsRangeIsInfinite) {
  const LinearProblem problem(Eigen::Matrix2d::Identity(), Eigen::Vector2d(-1.0, 0.5), {{0.0, 1.0}, {0.0, 1.0}});
  const Uncertainty told = uncertainty(problem, {0.0, 0.5});
  EXPECT_TRUE(std::isinf(told.parameters[0].standard_error));
  EXPECT_TRUE(std::isinf(told.parameters[0].half_width));
  EXPECT_FALSE(told.parameters[0].determined);
  EXPECT_FALSE(told.parameters[0].why_not.empty());
  EXPECT_TRUE(std::isfinite(told.parameters[1].standard_error));
}

TEST(Uncertainty, OfAsManySamplesAsParametersDeterminesNothing) {
  const auto all = goniometer_samples(published("metal-skin-5p"), 0.03, 18);
  const std::vector<BrdfSample> samples{all[10], all[55], all[95], all[120], all[150]};
  const auto problem = fit_problem("five_parameter", 180, samples, Residual::linear);
  const auto found = descend(*problem, truth_of(published("metal-skin-5p")), {}).parameters;
  for (const auto& p : uncertainty(*problem, found).parameters) {
    EXPECT_FALSE(p.determined);
    EXPECT_FALSE(std::isfinite(p.half_width));
  }
}

// A fit that meets every sample leaves nothing from which to tell an error.
TEST(Uncertainty, OfAnExactFitToAsManySamplesAsParametersIsInfinite) {
  const LinearProblem problem(Eigen::Matrix2d::Identity(), Eigen::Vector2d(0.25, 0.5), {{0.0, 1.0}, {0.0, 1.0}});
  for (const auto& p : uncertainty(problem, {0.25, 0.5}).parameters) {
    EXPECT_TRUE(std::isinf(p.standard_error));
    EXPECT_TRUE(std::isinf(p.half_width));
    EXPECT_FALSE(p.determined);
    EXPECT_EQ(p.why_not, "there are no more samples than parameters");
  }
}

// Three directions hold three numbers: five parameters have two directions too many.
TEST(Uncertainty, OfDataThatLackRankIsSymmetricAndWithoutNan) {
  const auto all = goniometer_samples(published("metal-skin-5p"), 0.03, 17);
  std::vector<BrdfSample> samples;
  for (const std::size_t k : {90U, 100U, 110U}) samples.insert(samples.end(), 4, all[k]);
  const auto problem = fit_problem("five_parameter", 180, samples, Residual::linear);
  const auto found = descend(*problem, truth_of(published("metal-skin-5p")), {}).parameters;
  const Uncertainty told = uncertainty(*problem, found);
  EXPECT_TRUE(told.correlation.allFinite());
  EXPECT_EQ(told.correlation, told.correlation.transpose());
  EXPECT_TRUE((told.correlation.diagonal().array() == 1.0).all());
  EXPECT_LE(told.correlation.cwiseAbs().maxCoeff(), 1.0 + 1e-12);
  int undetermined = 0;
  for (const auto& p : told.parameters) undetermined += p.determined ? 0 : 1;
  EXPECT_GE(undetermined, 2);
}

}  // namespace
}  // namespace lrcs
