#include "fit/non_negative.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace lrcs {
namespace {

double alone(const Eigen::VectorXd& column, const Eigen::VectorXd& target) {
  const double squares = column.squaredNorm();
  return squares > 0.0 ? std::max(column.dot(target) / squares, 0.0) : 0.0;
}

}  // namespace

Eigen::Vector2d non_negative_pair(const Eigen::MatrixX2d& columns, const Eigen::VectorXd& target) {
  Eigen::Vector2d both = (columns.transpose() * columns).ldlt().solve(columns.transpose() * target);
  if (both.allFinite() && both.minCoeff() >= 0.0) return both;
  Eigen::Vector2d first(alone(columns.col(0), target), 0.0);
  Eigen::Vector2d second(0.0, alone(columns.col(1), target));
  return (columns * first - target).squaredNorm() <= (columns * second - target).squaredNorm() ? first : second;
}

}  // namespace lrcs
