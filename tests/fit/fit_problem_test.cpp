#include "fit/fit_problem.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "fit/brdf_fit.h"
#include "tests/brdf/random_parameters.h"
#include "tests/fit/goniometer_data.h"

namespace lrcs {
namespace {

template <class Form>
class FitProblemOf : public testing::Test {
 protected:
  static std::unique_ptr<FitProblem> problem(Residual residual) {
    return fit_problem(Form::name, 180, goniometer_samples(published("metal-skin-9p"), 0.05, 8), residual);
  }
  static std::vector<double> random_place(RandomDirections& random) {
    const auto values = random_parameters<Form>(random);
    return {values.begin(), values.end()};
  }
};
TYPED_TEST_SUITE(FitProblemOf, EveryForm);

TYPED_TEST(FitProblemOf, HasSquaresThatAddUpToE) {
  RandomDirections random(8);
  const auto samples = goniometer_samples(published("metal-skin-9p"), 0.05, 8);
  const auto problem = this->problem(Residual::linear);
  for (int repeat = 0; repeat < 20; ++repeat) {
    const auto place = this->random_place(random);
    Eigen::VectorXd residual;
    problem->residuals(place, residual, nullptr);
    const double e = norm_e(find_brdf_form(TypeParam::name)->make(place, 180), samples);
    EXPECT_NEAR(100.0 * residual.squaredNorm(), e, 1e-9 * e);
  }
}

TYPED_TEST(FitProblemOf, HasTheJacobianOfItsDifferences) {
  RandomDirections random(9);
  for (const Residual kind : {Residual::linear, Residual::logarithmic}) {
    const auto problem = this->problem(kind);
    for (int repeat = 0; repeat < 5; ++repeat) {
      const auto place = this->random_place(random);
      Eigen::VectorXd residual, up, down;
      Eigen::MatrixXd jacobian;
      problem->residuals(place, residual, &jacobian);
      for (std::size_t k = 0; k < place.size(); ++k) {
        if (place[k] < 0.01 || place[k] > 0.95 * TypeParam::parameters[k].most) continue;  // no room, or rounding
        const double h = 1e-5 * place[k];
        auto there = place;
        there[k] = place[k] + h;
        problem->residuals(there, up, nullptr);
        there[k] = place[k] - h;
        problem->residuals(there, down, nullptr);
        const Eigen::VectorXd column = jacobian.col(static_cast<Eigen::Index>(k));
        EXPECT_LE(((up - down) / (2.0 * h) - column).norm(), 1e-5 * column.norm() + 1e-10 * residual.norm() / h)
            << TypeParam::parameters[k].name << " = " << place[k];
      }
    }
  }
}

// Karush, Kuhn and Tucker: the gradient is zero, or points out of the range at whose end the parameter is.
TYPED_TEST(FitProblemOf, HasLinearParametersThatNonNegativeLeastSquaresAskFor) {
  RandomDirections random(10);
  const auto problem = this->problem(Residual::linear);
  for (int repeat = 0; repeat < 50; ++repeat) {
    auto place = this->random_place(random);
    const double squares = problem->solve_linear(place);
    Eigen::VectorXd residual;
    Eigen::MatrixXd jacobian;
    problem->residuals(place, residual, &jacobian);
    EXPECT_NEAR(squares, residual.squaredNorm(), 1e-10 * (1.0 + squares));
    for (std::size_t k = 0; k < place.size(); ++k) {
      const FormParameter& p = TypeParam::parameters[k];
      if (!p.is_linear) continue;
      ASSERT_GE(place[k], 0.0);
      const Eigen::VectorXd column = jacobian.col(static_cast<Eigen::Index>(k));
      const double gradient = column.dot(residual) / (column.norm() * (1.0 + residual.norm()));
      constexpr double rounding = 1e-9;
      if (place[k] > 0.0) {
        EXPECT_LE(gradient, rounding) << p.name;
      }
      if (place[k] < p.most) {
        EXPECT_GE(gradient, -rounding) << p.name;
      }
    }
  }
}

TYPED_TEST(FitProblemOf, TellsTheSquaresOfWhatItSolvedForLogarithmsToo) {
  RandomDirections random(11);
  const auto problem = this->problem(Residual::logarithmic);
  for (int repeat = 0; repeat < 20; ++repeat) {
    auto place = this->random_place(random);
    const double squares = problem->solve_linear(place);
    Eigen::VectorXd residual;
    problem->residuals(place, residual, nullptr);
    EXPECT_EQ(squares, residual.squaredNorm());
  }
}

TEST(FitProblem, GivesLogarithmsAMeanSquare) {
  auto samples = goniometer_samples(Lambert(0.5));
  const auto problem = fit_problem("lambert", 180, samples, Residual::logarithmic);
  Eigen::VectorXd residual;
  problem->residuals(std::vector<double>{0.05}, residual, nullptr);
  EXPECT_NEAR(residual.squaredNorm(), std::pow(std::log(10.0), 2.0), 1e-12);
}

TEST(FitProblem, RefusesWhatHasNoSize) {
  auto samples = goniometer_samples(Lambert(0.0));
  EXPECT_THROW((void)fit_problem("lambert", 180, samples, Residual::linear), std::domain_error);
  EXPECT_THROW((void)fit_problem("ward", 180, goniometer_samples(Lambert(0.5)), Residual::linear),
               std::invalid_argument);
}

}  // namespace
}  // namespace lrcs
