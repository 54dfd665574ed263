#include "fit/brdf_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "base/input_error.h"
#include "tests/fit/goniometer_data.h"

namespace lrcs {
namespace {

FitOptions seeded(std::uint64_t seed) {
  FitOptions options;
  options.gsaa.seed = seed;
  return options;
}

// Enough for five parameters and fewer.
FitOptions quick(std::uint64_t seed = 1) {
  FitOptions options = seeded(seed);
  options.starts = 8;
  options.neighbours = 4;
  return options;
}

void expect_same_parameters(const BrdfFit& a, const BrdfFit& b, double relative) {
  for (std::size_t k = 0; k < a.parameters.size(); ++k)
    EXPECT_NEAR(a.parameters[k].value, b.parameters[k].value, relative * std::abs(b.parameters[k].value))
        << a.parameters[k].name;
}

TEST(BrdfFit, OfCleanDataIsExactWithFiveParameters) {
  for (const char* name : {"metal-skin-5p", "painted-steel-5p"})
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const BrdfFit fit = fit_brdf(goniometer_data(published(name)), "five_parameter", seeded(seed));
      EXPECT_LT(fit.e_percent, 1e-10) << name << " seed " << seed;
      EXPECT_TRUE(fit.converged);
      const auto truth = truth_of(published(name));
      for (std::size_t k = 0; k < truth.size(); ++k)
        EXPECT_NEAR(fit.parameters[k].value, truth[k], 1e-6 * std::abs(truth[k])) << name << fit.parameters[k].name;
    }
}

TEST(BrdfFit, OfCleanDataDeterminesEveryParameterThatChangesThem) {
  for (const char* name : {"metal-skin-5p", "painted-steel-5p"}) {
    const BrdfFit fit = fit_brdf(goniometer_data(published(name)), "five_parameter", quick());
    for (const FittedParameter& p : fit.parameters) {
      EXPECT_TRUE(p.determined) << name << " " << p.name << ": " << p.why_not;
      EXPECT_LE(p.standard_error, 1e-5 * std::abs(p.value)) << name << " " << p.name;
    }
    EXPECT_EQ(fit.status, "converged");
  }
}

TEST(BrdfFit, OfCleanDataIsExactWithNineParameters) {
  for (const Material& material : material_library())
    for (std::uint64_t seed = 1; seed <= 2; ++seed)
      EXPECT_LT(fit_brdf(goniometer_data(material.brdf), "nine_parameter", seeded(seed)).e_percent, 1e-10)
          << material.name << " seed " << seed;
}

TEST(BrdfFit, OfCleanDataFindsTheTruthOfEveryOtherForm) {
  const std::vector<Brdf> truths{Lambert(0.37), Steinvall(0.8, 0.1, 0.2, 1.5), Phong(0.3, 0.5, 25.0),
                                 CookTorranceBeckmann(0.2, 0.7, 0.04, 0.3), CookTorranceGgx(0.3, 0.6, 0.5, 0.15)};
  for (const Brdf& brdf : truths)
    for (const Residual residual : {Residual::linear, Residual::logarithmic}) {
      FitOptions options = quick();
      options.residual = residual;
      const std::string form = words_of(brdf).form->name;
      const BrdfFit fit = fit_brdf(goniometer_data(brdf), form, options);
      const auto truth = truth_of(brdf);
      for (std::size_t k = 0; k < truth.size(); ++k)
        EXPECT_NEAR(fit.parameters[k].value, truth[k], 1e-6 * truth[k]) << form << " " << fit.parameters[k].name;
      EXPECT_LT(fit.e_percent, 1e-10) << form;
    }
}

TEST(BrdfFit, OfLogarithmsFindsTheTruthOfCleanData) {
  FitOptions options = quick();
  options.residual = Residual::logarithmic;
  for (const char* name : {"metal-skin-5p", "painted-steel-5p"}) {
    const BrdfFit fit = fit_brdf(goniometer_data(published(name)), "five_parameter", options);
    EXPECT_LT(fit.rms_logarithm, 1e-7) << name;
    EXPECT_LT(fit.e_percent, 1e-10) << name;
  }
}

TEST(BrdfFit, OfLambertIsWeightedLeastSquares) {
  auto samples = goniometer_samples(Lambert(0.4), 0.2, 2);
  double product = 0.0, square = 0.0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    samples[k].weight = 0.5 + static_cast<double>(k % 5);
    const double c = std::cos(samples[k].theta_r);
    product += samples[k].weight * samples[k].f_r * c * c;
    square += samples[k].weight * c * c;
  }
  const BrdfFit fit = fit_brdf(measurement_of(samples), "lambert");
  EXPECT_NEAR(fit.parameters[0].value, std::numbers::pi * product / square, 1e-12);
  EXPECT_EQ(std::get<Lambert>(fit.material.brdf).reflectance(), fit.parameters[0].value);
}

TEST(BrdfFit, OfLambertToLogarithmsIsTheGeometricMean) {
  auto samples = goniometer_samples(Lambert(0.9));
  double logarithms = 0.0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    samples[k].f_r *= std::pow(10.0, -static_cast<double>(k % 4));  // four decades
    logarithms += std::log(samples[k].f_r);
  }
  FitOptions options;
  options.residual = Residual::logarithmic;
  const BrdfFit fit = fit_brdf(measurement_of(samples), "lambert", options);
  const double mean = std::exp(logarithms / static_cast<double>(samples.size()));
  EXPECT_NEAR(fit.parameters[0].value, std::numbers::pi * mean, 1e-9);
}

TEST(BrdfFit, OfLambertBrighterThanWhiteSaysThatItIsAtItsEnd) {
  auto samples = goniometer_samples(Lambert(1.0));
  for (BrdfSample& s : samples) s.f_r *= 1.3;
  const BrdfFit fit = fit_brdf(measurement_of(samples), "lambert");
  EXPECT_EQ(fit.parameters[0].value, 1.0);
  EXPECT_FALSE(fit.parameters[0].determined);
  EXPECT_TRUE(std::isinf(fit.parameters[0].standard_error));
  EXPECT_NE(fit.status.find("reflectance"), std::string::npos) << fit.status;
}

TEST(BrdfFit, WithNineParametersIsBetterThanWithFiveOnDataOfNine) {
  for (const char* name : {"metal-skin-9p", "painted-steel-9p"}) {
    const auto data = goniometer_data(published(name), 0.03, 3);
    const double five = fit_brdf(data, "five_parameter").e_percent;
    EXPECT_LT(fit_brdf(data, "nine_parameter").e_percent, 0.9 * five) << name;
  }
}

TEST(BrdfFit, WithNineParametersIsNoWorseThanWithFiveEvenIfTheSearchSeesFewSamples) {
  for (const unsigned seed : {1U, 2U, 3U, 4U}) {
    const auto data = goniometer_data(published("painted-steel-5p"), 0.1, seed);
    FitOptions options = quick();
    options.starts = options.neighbours = 0;
    options.search_rows = 12;
    EXPECT_LE(fit_brdf(data, "nine_parameter", options).e_percent,
              fit_brdf(data, "five_parameter", options).e_percent * (1.0 + 1e-9))
        << seed;
  }
}

// All that tells two exact fits apart is rounding.
TEST(BrdfFit, PrefersTheFewestParametersOfThoseThatAreExact) {
  for (const char* name : {"metal-skin-5p", "painted-steel-5p"}) {
    const auto data = goniometer_data(published(name));
    const BrdfFit five = fit_brdf(data, "five_parameter", quick()), nine = fit_brdf(data, "nine_parameter", quick());
    EXPECT_NEAR(nine.criterion - five.criterion, 4.0 * std::log(data.samples.size()), 1e-9) << name;
  }
}

TEST(BrdfFit, CountsTheEvaluationsOfTheFitThatItContains) {
  const auto data = goniometer_data(published("painted-steel-5p"), 0.03, 3);
  FitOptions least;
  least.starts = least.neighbours = least.gsaa.generations = 0;
  const int five = fit_brdf(data, "five_parameter", least).evaluations;
  EXPECT_GT(five, least.gsaa.population);
  EXPECT_GT(fit_brdf(data, "nine_parameter", least).evaluations, five + least.gsaa.population);
}

TEST(BrdfFit, LooksAtAllSamplesInTheEnd) {
  const auto data = goniometer_data(published("metal-skin-5p"), 0.03, 4);
  FitOptions few = quick();
  few.search_rows = 40;
  const BrdfFit all = fit_brdf(data, "five_parameter", quick());
  const BrdfFit thinned = fit_brdf(data, "five_parameter", few);
  EXPECT_NEAR(thinned.e_percent, all.e_percent, 1e-9 * all.e_percent);
  EXPECT_EQ(thinned.samples, data.samples.size());
  expect_same_parameters(thinned, all, 1e-5);
}

// The search takes one of 50 samples, and the scans are 50 long.
TEST(BrdfFit, FindsALobeInScansAsLongAsTheSearchsStep) {
  const CookTorranceGgx truth(0.1, 0.8, 0.3, 0.05);
  std::vector<BrdfSample> samples;
  for (int i = 5; i <= 50; i += 5)
    for (int phi = 0; phi < 50; ++phi)
      for (int r = 0; r < 50; ++r) {
        BrdfSample s{i * degree, (79.0 - 1.5 * r) * degree, (130 + phi) * degree};
        s.f_r = f_r_angles(truth, s.theta_i, s.theta_r, s.phi);
        samples.push_back(s);
      }
  FitOptions options = quick();
  options.search_rows = static_cast<int>(samples.size() / 50);
  EXPECT_LT(fit_brdf(measurement_of(samples), "cook_torrance_ggx", options).e_percent, 1e-10);
}

TEST(BrdfFit, DoesNotSeeASampleOfWeightZero) {
  const auto samples = goniometer_samples(published("metal-skin-5p"), 0.03, 5);
  auto more = samples;
  for (std::size_t k = 0; k < 40; ++k) {
    BrdfSample wrong = samples[k];
    wrong.f_r = k % 2 == 0 ? 0.0 : 100.0;
    wrong.weight = 0.0;
    more.insert(more.begin() + static_cast<std::ptrdiff_t>(3 * k), wrong);
  }
  for (const Residual residual : {Residual::linear, Residual::logarithmic}) {
    FitOptions options = quick();
    options.residual = residual;
    const BrdfFit without = fit_brdf(measurement_of(samples), "five_parameter", options);
    const BrdfFit with = fit_brdf(measurement_of(more), "five_parameter", options);
    for (std::size_t k = 0; k < 5; ++k) {
      EXPECT_EQ(with.parameters[k].value, without.parameters[k].value);
      EXPECT_EQ(with.parameters[k].half_width_95, without.parameters[k].half_width_95);
    }
    EXPECT_EQ(with.e_percent, without.e_percent);
    EXPECT_EQ(with.rms_logarithm, without.rms_logarithm);
    EXPECT_EQ(with.criterion, without.criterion);
    EXPECT_EQ(with.samples, without.samples);
  }
}

TEST(BrdfFit, TakesADoubledWeightAsARepeatedSample) {
  auto doubled = goniometer_samples(published("painted-steel-5p"), 0.03, 6);
  auto repeated = doubled;
  for (std::size_t k = 0; k < doubled.size(); k += 3) {
    repeated.push_back(doubled[k]);
    doubled[k].weight = 2.0;
  }
  const BrdfFit a = fit_brdf(measurement_of(doubled), "five_parameter", quick());
  const BrdfFit b = fit_brdf(measurement_of(repeated), "five_parameter", quick());
  EXPECT_NEAR(a.e_percent, b.e_percent, 1e-10 * b.e_percent);
  expect_same_parameters(a, b, 1e-5);
}

TEST(BrdfFit, ScalesItsLinearParametersWithTheData) {
  const auto samples = goniometer_samples(published("metal-skin-5p"), 0.03, 7);
  const BrdfFit one = fit_brdf(measurement_of(samples), "five_parameter", quick());
  for (const double c : {1e-6, 0.3, 1e6}) {
    auto scaled = samples;
    for (BrdfSample& s : scaled) s.f_r *= c;
    const BrdfFit fit = fit_brdf(measurement_of(scaled), "five_parameter", quick());
    EXPECT_NEAR(fit.e_percent, one.e_percent, 1e-9 * one.e_percent) << c;
    for (std::size_t k = 0; k < 5; ++k) {
      const double factor = k == 0 || k == 4 ? c : 1.0;
      EXPECT_NEAR(fit.parameters[k].value, factor * one.parameters[k].value,
                  1e-5 * factor * std::abs(one.parameters[k].value))
          << c << fit.parameters[k].name;
      EXPECT_NEAR(fit.parameters[k].standard_error, factor * one.parameters[k].standard_error,
                  1e-3 * factor * one.parameters[k].standard_error)
          << c << fit.parameters[k].name;
      EXPECT_EQ(fit.parameters[k].determined, one.parameters[k].determined) << c << fit.parameters[k].name;
    }
  }
}

TEST(BrdfFit, DoesNotDependOnTheOrderOfTheSamples) {
  auto samples = goniometer_samples(published("painted-steel-5p"), 0.03, 8);
  const BrdfFit as_given = fit_brdf(measurement_of(samples), "five_parameter", quick());
  std::mt19937 engine(8);
  std::shuffle(samples.begin(), samples.end(), engine);
  const BrdfFit shuffled = fit_brdf(measurement_of(samples), "five_parameter", quick());
  EXPECT_NEAR(shuffled.e_percent, as_given.e_percent, 1e-10 * as_given.e_percent);
  expect_same_parameters(shuffled, as_given, 1e-5);
}

TEST(BrdfFit, RefusesFewerSamplesThanParameters) {
  auto samples = goniometer_samples(published("metal-skin-5p"));
  samples.resize(9);
  EXPECT_NO_THROW((void)fit_brdf(measurement_of(samples), "nine_parameter", quick()));
  samples[4].weight = 0.0;
  EXPECT_THROW((void)fit_brdf(measurement_of(samples), "nine_parameter", quick()), InputError);
  samples.resize(4);
  EXPECT_THROW((void)fit_brdf(measurement_of(samples), "five_parameter", quick()), InputError);
}

TEST(BrdfFit, RefusesSamplesThatAreAllZero) {
  auto samples = goniometer_samples(published("metal-skin-5p"));
  for (const double nothing : {0.0, 1e-170}) {
    for (BrdfSample& s : samples) s.f_r = nothing;
    EXPECT_THROW((void)fit_brdf(measurement_of(samples), "lambert"), InputError) << nothing;
  }
}

// A lobe of a degree in a scan of 4 deg steps: two or three samples hold the peak.
TEST(BrdfFit, WarnsOfALobeThatIsHardlySampled) {
  const auto warnings_of = [](const Brdf& brdf, Residual residual) {
    FitOptions options = quick();
    options.residual = residual;
    return fit_brdf(measurement_of(goniometer_samples(brdf)), "phong", options).warnings;
  };
  const auto sharp = warnings_of(Phong(0.3, 0.5, 2e4), Residual::linear);
  ASSERT_EQ(sharp.size(), 1U);
  EXPECT_EQ(sharp.front().rfind("1 of 164 samples hold half of what E weighs", 0), 0U) << sharp.front();
  EXPECT_TRUE(warnings_of(Phong(0.3, 0.5, 2e4), Residual::logarithmic).empty());
  EXPECT_TRUE(warnings_of(Phong(0.3, 0.5, 20.0), Residual::linear).empty());
}

TEST(NormE, IsTheSumThatItSays) {
  auto samples = goniometer_samples(published("metal-skin-9p"), 0.2, 9);
  for (std::size_t k = 0; k < samples.size(); ++k) samples[k].weight = static_cast<double>(k % 7);
  const Brdf& brdf = published("painted-steel-5p");
  long double difference = 0.0L, all = 0.0L;
  for (const BrdfSample& s : samples) {
    const long double c = std::cos(static_cast<long double>(s.theta_r));
    const long double f = f_r_angles(brdf, s.theta_i, s.theta_r, s.phi);
    difference += s.weight * (f - s.f_r) * (f - s.f_r) * c * c;
    all += s.weight * (s.f_r * c) * (s.f_r * c);
  }
  const auto e = static_cast<double>(100.0L * difference / all);
  EXPECT_NEAR(norm_e(brdf, samples), e, 1e-13 * e);
  EXPECT_LT(norm_e(brdf, goniometer_samples(brdf)), 1e-25);
}

}  // namespace
}  // namespace lrcs
