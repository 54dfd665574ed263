#include "fit/non_negative.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace lrcs {
namespace {

Eigen::VectorXd random_vector(std::mt19937& engine, Eigen::Index size) {
  std::normal_distribution<double> z;
  return Eigen::VectorXd::NullaryExpr(size, [&](Eigen::Index) { return z(engine); });
}

// The least squares over a grid of non-negative pairs that is refined around its best point again and again.
double brute_force(const Eigen::MatrixX2d& columns, const Eigen::VectorXd& target) {
  constexpr int half = 10;
  Eigen::Vector2d best(0.0, 0.0);
  double least = target.squaredNorm();
  for (double step = 10.0; step > 1e-9; step *= 0.5) {
    const Eigen::Vector2d middle = best;
    for (int i = -half; i <= half; ++i)
      for (int j = -half; j <= half; ++j) {
        const Eigen::VectorXd c = (middle + step * Eigen::Vector2d(i, j)).cwiseMax(0.0);
        const double squares = (columns * c - target).squaredNorm();
        if (squares < least) least = squares, best = c;
      }
  }
  return least;
}

TEST(NonNegative, IsWhatAGridFinds) {
  std::mt19937 engine(3);
  std::array<int, 4> cases{};
  for (int repeat = 0; repeat < 60; ++repeat) {
    Eigen::MatrixX2d columns(6, 2);
    columns << random_vector(engine, 6), random_vector(engine, 6);
    const Eigen::VectorXd target = random_vector(engine, 6);
    const Eigen::VectorXd c = non_negative(columns, target);
    ASSERT_GE(c.minCoeff(), 0.0);
    ++cases[static_cast<std::size_t>((c[0] > 0.0 ? 1 : 0) + (c[1] > 0.0 ? 2 : 0))];
    EXPECT_NEAR((columns * c - target).squaredNorm(), brute_force(columns, target), 1e-10 * target.squaredNorm());
  }
  for (const int count : cases) EXPECT_GE(count, 5);  // both free, either at 0, both at 0
}

TEST(NonNegative, OfColumnsThatDependIsAsGoodAsOneOfThem) {
  std::mt19937 engine(4);
  for (const double factor : {0.0, 1.0, 2.5, 1e-9}) {
    Eigen::MatrixX2d columns(6, 2);
    columns.col(0) = random_vector(engine, 6);
    columns.col(1) = factor * columns.col(0);
    const Eigen::VectorXd target = 0.7 * columns.col(0) + 0.1 * random_vector(engine, 6);
    const double alone = columns.col(0).dot(target) / columns.col(0).squaredNorm();
    const Eigen::VectorXd c = non_negative(columns, target);
    ASSERT_GE(c.minCoeff(), 0.0) << factor;
    EXPECT_NEAR((columns * c - target).squaredNorm(), (alone * columns.col(0) - target).squaredNorm(), 1e-12);
  }
}

// Of more columns: by the conditions of Karush, Kuhn and Tucker.
TEST(NonNegative, OfFourColumnsHasNoDirectionInWhichItFalls) {
  std::mt19937 engine(5);
  for (int repeat = 0; repeat < 100; ++repeat) {
    Eigen::MatrixXd columns(9, 4);
    for (Eigen::Index k = 0; k < 4; ++k)
      columns.col(k) = std::pow(10.0, static_cast<double>(k)) * random_vector(engine, 9);
    if (repeat % 3 == 0) columns.col(2) = 5.0 * columns.col(1);
    const Eigen::VectorXd target = random_vector(engine, 9);
    const Eigen::VectorXd c = non_negative(columns, target);
    ASSERT_GE(c.minCoeff(), 0.0);
    const Eigen::VectorXd gradient = columns.transpose() * (columns * c - target);
    for (Eigen::Index k = 0; k < 4; ++k) {
      const double rounding = 1e-11 * columns.col(k).norm() * target.norm();
      EXPECT_GE(gradient[k], -rounding);
      if (c[k] > 0.0) {
        EXPECT_LE(gradient[k], rounding);
      }
    }
  }
}

TEST(NonNegative, OfEmptyColumnsIsFinite) {
  EXPECT_EQ(
      (Eigen::MatrixX2d::Zero(4, 2) * non_negative(Eigen::MatrixX2d::Zero(4, 2), Eigen::VectorXd::Ones(4))).norm(),
      0.0);
}

}  // namespace
}  // namespace lrcs
