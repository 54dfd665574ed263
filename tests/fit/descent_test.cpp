#include "fit/descent.h"

#include <gtest/gtest.h>

#include "brdf/form_list.h"
#include "fit/polish.h"
#include "tests/brdf/random_parameters.h"
#include "tests/fit/goniometer_data.h"
#include "tests/fit/linear_problem.h"

namespace lrcs {
namespace {

// [x - p + 0.1 (y - q)]^2 + (y - q)^2, within the given range of each. Where x is held at e, the least is at
// y = q - 0.1 (e - p)/1.01.
LinearProblem bowl(double p, double q, double least, double most) {
  Eigen::Matrix2d a;
  a << 1.0, 0.1, 0.0, 1.0;
  return {a, a * Eigen::Vector2d(p, q), {{least, most}, {least, most}}};
}

TEST(Descent, ReachesTheBottomOfALinearProblem) {
  const Polished end = descend(bowl(0.3, 0.7, -5.0, 5.0), {-4.0, 4.0}, {});
  EXPECT_TRUE(end.converged);
  EXPECT_NEAR(end.parameters[0], 0.3, 1e-7);
  EXPECT_NEAR(end.parameters[1], 0.7, 1e-7);
  EXPECT_LT(end.squares, 1e-14);
}

TEST(Descent, LeavesAParameterAtItsEndWhereTheSquaresFallOutward) {
  const Polished low = descend(bowl(-2.0, 0.5, 0.0, 1.0), {0.0, 0.9}, {});
  EXPECT_EQ(low.parameters[0], 0.0);
  const Polished high = descend(bowl(2.0, 0.5, 0.0, 1.0), {1.0, 0.9}, {});
  EXPECT_EQ(high.parameters[0], 1.0);
  EXPECT_NEAR(low.parameters[1], 0.5 - 0.1 * (0.0 + 2.0) / 1.01, 1e-7);
  EXPECT_NEAR(high.parameters[1], 0.5 - 0.1 * (1.0 - 2.0) / 1.01, 1e-7);
}

TEST(Descent, TakesAParameterOffItsEndWhereTheSquaresFallInward) {
  for (const double start : {0.0, 1.0}) {
    const Polished end = descend(bowl(0.4, 0.6, 0.0, 1.0), {start, start}, {});
    EXPECT_NEAR(end.parameters[0], 0.4, 1e-7);
    EXPECT_NEAR(end.parameters[1], 0.6, 1e-7);
  }
}

TEST(Descent, HoldsTheParameterThatIsHeld) {
  const Polished end = descend(bowl(0.4, 0.6, 0.0, 1.0), {0.9, 0.1}, {}, 0);
  EXPECT_EQ(end.parameters[0], 0.9);
  EXPECT_NEAR(end.parameters[1], 0.6 - 0.1 * 0.5 / 1.01, 1e-7);
}

TEST(Descent, BringsAStartBeyondARangeIntoIt) {
  const Polished end = descend(bowl(0.4, 0.6, 0.0, 1.0), {-3.0, 7.0}, {});
  EXPECT_NEAR(end.parameters[0], 0.4, 1e-7);
  EXPECT_NEAR(end.parameters[1], 0.6, 1e-7);
}

TEST(Descent, StopsWhereItsPatienceEnds) {
  const auto problem =
      fit_problem("nine_parameter", 180, goniometer_samples(published("metal-skin-9p"), 0.03, 5), Residual::linear);
  const Polished end = descend(*problem, {0.2, 1.0, -5.0, 2.0, 0.1, 1.0, 1.0, 1.0, 1.0}, {2, 0.0});
  EXPECT_FALSE(end.converged);
  EXPECT_LE(end.evaluations, 6);
}

template <class Form>
class DescentOf : public testing::Test {};
TYPED_TEST_SUITE(DescentOf, EveryForm);

TYPED_TEST(DescentOf, KeepsEveryParameterInItsRangeAndNeverRises) {
  RandomDirections random(6);
  const auto problem =
      fit_problem(TypeParam::name, 180, goniometer_samples(published("painted-steel-9p"), 0.03, 6), Residual::linear);
  for (int repeat = 0; repeat < 10; ++repeat) {
    const auto values = random_parameters<TypeParam>(random);
    const std::vector<double> start(values.begin(), values.end());
    Eigen::VectorXd residual;
    problem->residuals(start, residual, nullptr);
    const Polished end = descend(*problem, start, {60, 1e-8});
    EXPECT_LE(end.squares, residual.squaredNorm());
    for (std::size_t k = 0; k < values.size(); ++k) {
      EXPECT_GE(end.parameters[k], TypeParam::parameters[k].least) << TypeParam::parameters[k].name;
      EXPECT_LE(end.parameters[k], TypeParam::parameters[k].most) << TypeParam::parameters[k].name;
    }
    problem->residuals(end.parameters, residual, nullptr);
    EXPECT_NEAR(end.squares, residual.squaredNorm(), 1e-14 * (1.0 + end.squares));
  }
}

TEST(Descent, EndsWhereCeresEnds) {
  for (const char* name : {"metal-skin-5p", "painted-steel-5p"}) {
    const auto problem =
        fit_problem("five_parameter", 180, goniometer_samples(published(name), 0.03, 7), Residual::linear);
    std::vector<double> start = truth_of(published(name));
    for (double& x : start) x *= 1.2;
    const Polished own = descend(*problem, start, {});
    const Polished ceres = polish(*problem, start);
    EXPECT_TRUE(own.converged);
    EXPECT_NEAR(own.squares, ceres.squares, 1e-12 * ceres.squares) << name;
    for (std::size_t k = 0; k < start.size(); ++k)
      EXPECT_NEAR(own.parameters[k], ceres.parameters[k], 1e-5 * std::abs(ceres.parameters[k])) << name << k;
  }
}

// A straight line through three points that lie on none: the least squares are not 0.
TEST(IsLeast, KnowsTheBottomWhateverTheUnits) {
  for (const double unit : {1e-6, 1.0, 1e6}) {
    Eigen::MatrixXd a(3, 2);
    a << 1.0, 0.0, 1.0, unit, 1.0, 2.0 * unit;
    const Eigen::Vector3d t(0.0, 1.0, 1.0);
    const LinearProblem line(a, t, {{-10.0, 10.0}, {-1e8, 1e8}});
    EXPECT_TRUE(is_least(line, {1.0 / 6.0, 0.5 / unit})) << unit;
    EXPECT_FALSE(is_least(line, {1.0 / 6.0 + 0.01, 0.5 / unit})) << unit;
    EXPECT_FALSE(is_least(line, {1.0 / 6.0, 0.51 / unit})) << unit;
  }
}

TEST(IsLeast, HoldsAParameterAtItsEnd) {
  EXPECT_TRUE(is_least(bowl(-2.0, 0.5, 0.0, 1.0), {0.0, 0.5 - 0.1 * 2.0 / 1.01}));
  EXPECT_FALSE(is_least(bowl(-2.0, 0.5, 0.0, 1.0), {0.0, 0.6}));
}

}  // namespace
}  // namespace lrcs
