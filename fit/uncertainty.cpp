#include "fit/uncertainty.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>

#include "fit/coordinate.h"
#include "fit/descent.h"
#include "fit/non_negative.h"

namespace lrcs {
namespace {

using Eigen::Index;
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double widest = 0.5;            // half an interval over the value
constexpr double narrow = 1e-6;           // the same: below, no curve shows, and of clean data the rise is rounding
constexpr double rank_tolerance = 1e-13;  // eigenvalue over the largest, columns scaled to 1: below, noise of rounding
constexpr double most_blind = 1e-6;       // of Inverse::blind, for a parameter to have an error at all
constexpr double honest_rise = 1.8;  // squares rise at the ends of an interval by what is foretold within this factor

// The residuals' derivatives in those parameters that are not at an end, columns of length 1.
struct Linearised {
  std::vector<Index> free;
  Eigen::VectorXd residual, length;
  Eigen::MatrixXd jacobian;

  Linearised(const FitProblem& problem, const std::vector<double>& values) {
    Eigen::MatrixXd all;
    problem.residuals(values, residual, &all);
    for (Index k = 0; k < all.cols(); ++k)
      if (!is_at_end(problem.parameters()[k], values[k]) && all.col(k).norm() > 0.0) free.push_back(k);
    jacobian.resize(all.rows(), static_cast<Index>(free.size()));
    length.resize(jacobian.cols());
    for (Index j = 0; j < jacobian.cols(); ++j) {
      length[j] = all.col(free[j]).norm();
      jacobian.col(j) = all.col(free[j]) / length[j];
    }
  }
};

// (J^T J)^-1 on the directions that the data tell of; `blind`: how far each parameter lies along those they do not.
struct Inverse {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd blind;

  explicit Inverse(const Eigen::MatrixXd& jacobian) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(jacobian.transpose() * jacobian);
    const auto size = jacobian.cols();
    matrix = Eigen::MatrixXd::Zero(size, size);
    blind = Eigen::VectorXd::Zero(size);
    for (Index j = 0; j < size; ++j) {
      const auto direction = eigen.eigenvectors().col(j);
      if (eigen.eigenvalues()[j] > rank_tolerance * eigen.eigenvalues()[size - 1])
        matrix += direction * direction.transpose() / eigen.eigenvalues()[j];
      else
        blind += direction.cwiseAbs2();
    }
  }
};

// Variances of the residuals: a constant share and one proportional to the square of the value, both times the weight,
// as noise of a detector and of a source are; from the squares of the residuals by reweighted least squares.
Eigen::VectorXd variances(const FitProblem& problem, const Linearised& l, const Eigen::MatrixXd& inverse) {
  const Eigen::MatrixX2d basis = problem.variance_basis();
  const Eigen::VectorXd leverage = (l.jacobian * inverse).cwiseProduct(l.jacobian).rowwise().sum().cwiseMin(0.999);
  const Eigen::VectorXd squares = l.residual.cwiseAbs2().cwiseQuotient((1.0 - leverage.array()).matrix());
  Eigen::VectorXd variance = Eigen::VectorXd::Constant(squares.size(), squares.mean());
  for (int round = 0; round < 20; ++round) {
    const Eigen::VectorXd floor = variance.cwiseMax(1e-6 * variance.mean() + std::numeric_limits<double>::min());
    const Eigen::MatrixX2d weighted = floor.cwiseInverse().asDiagonal() * basis;
    variance = basis * non_negative_pair(weighted, squares.cwiseQuotient(floor));
  }
  return variance;
}

// Of Student's distribution: the half width of a 95 % interval over the standard error.
double quantile_95(Index freedom) {
  if (freedom < 1) return infinite;
  return boost::math::quantile(boost::math::students_t(static_cast<double>(freedom)), 0.975);
}

// Rise of the squares where parameter j is held `shift` away and the others are fitted again, over the rise that the
// linearised model foretells.
double rise_ratio(const FitProblem& problem, const std::vector<double>& values, const Linearised& l,
                  const Eigen::MatrixXd& inverse, Index j, double shift) {
  const FormParameter& p = problem.parameters()[l.free[j]];
  std::vector<double> there = values;
  there[l.free[j]] += shift;
  if (!(there[l.free[j]] >= p.least && there[l.free[j]] <= p.most)) return 0.0;
  const Polished again = descend(problem, there, {30, 1e-4}, static_cast<int>(l.free[j]));
  const double scaled = shift * l.length[j];
  return (again.squares - l.residual.squaredNorm()) / (scaled * scaled / inverse(j, j));
}

bool is_honest(double ratio) {
  return ratio > 1.0 / honest_rise && ratio < honest_rise;
}

}  // namespace

Uncertainty uncertainty(const FitProblem& problem, const std::vector<double>& parameters) {
  const auto size = static_cast<Index>(parameters.size());
  const Linearised l(problem, parameters);
  Uncertainty result;
  result.correlation = Eigen::MatrixXd::Identity(size, size);
  for (const FormParameter& p : problem.parameters()) {
    const double value = parameters[result.parameters.size()];
    result.parameters.push_back(
        {infinite, infinite, false, is_at_end(p, value) ? "at the end of its range" : "no effect"});
  }
  if (l.free.empty()) return result;
  const Inverse inverse(l.jacobian);
  const Eigen::VectorXd variance = variances(problem, l, inverse.matrix);
  const Eigen::MatrixXd covariance =
      inverse.matrix * (l.jacobian.transpose() * variance.asDiagonal() * l.jacobian) * inverse.matrix;
  const double t = quantile_95(l.residual.size() - static_cast<Index>(l.free.size()));
  for (Index j = 0; j < static_cast<Index>(l.free.size()); ++j) {
    ParameterError95& error = result.parameters[l.free[j]];
    const double value = parameters[l.free[j]];
    if (inverse.blind[j] > most_blind) {
      error.why_not = "the data do not tell it from others";
      continue;
    }
    error.standard_error = std::sqrt(covariance(j, j)) / l.length[j];
    error.half_width = t * error.standard_error;
    const bool is_narrow = error.half_width <= narrow * std::abs(value);
    const double up = is_narrow ? 1.0 : rise_ratio(problem, parameters, l, inverse.matrix, j, error.half_width);
    const double down = is_narrow ? 1.0 : rise_ratio(problem, parameters, l, inverse.matrix, j, -error.half_width);
    if (error.half_width > widest * std::abs(value)) {
      error.why_not = "its 95 % interval is wider than half its value";
    } else if (!is_honest(up) || !is_honest(down)) {
      error.why_not = "the error does not rise evenly around it";
    } else {
      error.why_not.clear();
      const double correction = 0.5 * (1.0 / std::sqrt(up) + 1.0 / std::sqrt(down));
      error.standard_error *= correction;
      error.half_width *= correction;
    }
    error.determined = error.why_not.empty();
    for (Index i = 0; i < j; ++i) {
      const double scale = std::sqrt(covariance(i, i) * covariance(j, j));
      if (!(scale > 0.0) || inverse.blind[i] > most_blind) continue;
      const double r = std::clamp(covariance(i, j) / scale, -1.0, 1.0);
      result.correlation(l.free[i], l.free[j]) = result.correlation(l.free[j], l.free[i]) = r;
    }
  }
  return result;
}

}  // namespace lrcs
