#include "fit/search.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "fit/coordinate.h"
#include "fit/uniform.h"
#include "tests/fit/goniometer_data.h"

namespace lrcs {
namespace {

// The best of descents from `count` places anywhere.
double best_of_descents(const FitProblem& problem, int count) {
  Uniform random(77);
  double best = 1e300;
  for (int k = 0; k < count; ++k) {
    std::vector<double> start;
    for (const FormParameter& p : problem.parameters()) start.push_back(value_at(p, 0.02 + 0.96 * random.next()));
    problem.solve_linear(start);
    best = std::min(best, descend(problem, start, {100, 1e-10}).squares);
  }
  return best;
}

struct Case {
  const char* material;
  const char* form;
  double noise;
};

class SearchOf : public testing::TestWithParam<Case> {};

TEST_P(SearchOf, IsAsGoodAsTheBestOfAHundredDescents) {
  const auto [material, form, noise] = GetParam();
  const auto problem = fit_problem(form, 180, goniometer_samples(published(material), noise, 11), Residual::linear);
  EXPECT_LE(search(*problem, {}).squares, 1.001 * best_of_descents(*problem, 100));
}

INSTANTIATE_TEST_SUITE_P(
    Noisy, SearchOf,
    testing::Values(Case{"metal-skin-5p", "five_parameter", 0.01}, Case{"metal-skin-5p", "five_parameter", 0.03},
                    Case{"painted-steel-5p", "five_parameter", 0.01}, Case{"painted-steel-5p", "five_parameter", 0.03},
                    Case{"painted-steel-9p", "five_parameter", 0.01}, Case{"metal-skin-9p", "five_parameter", 0.03},
                    Case{"metal-skin-9p", "nine_parameter", 0.01}, Case{"metal-skin-9p", "nine_parameter", 0.03},
                    Case{"painted-steel-9p", "nine_parameter", 0.01},
                    Case{"painted-steel-9p", "nine_parameter", 0.03}));

TEST(Search, IsNoWorseThanAPlaceItIsGiven) {
  const auto truth = truth_of(published("metal-skin-9p"));
  const auto problem =
      fit_problem("nine_parameter", 180, goniometer_samples(published("metal-skin-9p"), 0.03, 12), Residual::linear);
  FitOptions least;
  least.starts = least.neighbours = least.gsaa.generations = 0;
  least.gsaa.population = 2;
  Eigen::VectorXd residual;
  problem->residuals(truth, residual, nullptr);
  EXPECT_LE(search(*problem, least, {truth}).squares, residual.squaredNorm());
}

TEST(Search, IsTheSameForTheSameSeed) {
  const auto problem =
      fit_problem("five_parameter", 180, goniometer_samples(published("metal-skin-5p"), 0.03, 13), Residual::linear);
  const Polished first = search(*problem, {});
  const Polished again = search(*problem, {});
  EXPECT_EQ(first.parameters, again.parameters);
  EXPECT_EQ(first.evaluations, again.evaluations);
}

}  // namespace
}  // namespace lrcs
