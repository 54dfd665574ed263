#include "fit/uncertainty.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>

#include "fit/coordinate.h"
#include "fit/descent.h"
#include "fit/linearised.h"
#include "fit/non_negative.h"

namespace lrcs {
namespace {

using Eigen::Index;
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double widest = 0.5;            // half an interval over the value
constexpr double narrow = 1e-6;           // the same: below, no curve shows, and of clean data the rise is rounding
constexpr double rank_tolerance = 1e-13;  // eigenvalue over the largest, columns scaled to 1: below, noise of rounding
constexpr double most_blind = 1e-6;       // of Inverse::blind, for a parameter to have an error at all
constexpr double rise_accuracy = 0.01;    // of the rise at the ends of an interval
constexpr double far_valley = 5.0;  // rise of the squares in another valley over that at the ends of an interval: from
                                    // there on chance does not explain it, wherever noise is large
constexpr double other_valley = 0.1;     // [part of the search range] in some coordinate: another valley
constexpr std::size_t most_valleys = 8;  // looked into
constexpr double honest_rise = 1.8;  // squares rise at the ends of an interval by what is foretold within this factor

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

// Variances of the residuals: a sum of what each kind of noise gives, from the squares of the residuals by reweighted
// least squares.
Eigen::VectorXd variances(const FitProblem& problem, const std::vector<double>& values, const Linearised& l,
                          const Eigen::MatrixXd& inverse) {
  const Eigen::MatrixXd basis = problem.variance_basis(values);
  const Eigen::VectorXd leverage = (l.jacobian * inverse).cwiseProduct(l.jacobian).rowwise().sum().cwiseMin(0.999);
  const Eigen::VectorXd squares = l.residual.cwiseAbs2().cwiseQuotient((1.0 - leverage.array()).matrix());
  Eigen::VectorXd variance = Eigen::VectorXd::Constant(squares.size(), squares.mean());
  for (int round = 0; round < 20; ++round) {
    const Eigen::VectorXd floor = variance.cwiseMax(1e-6 * variance.mean() + std::numeric_limits<double>::min());
    const Eigen::MatrixXd weighted = floor.cwiseInverse().asDiagonal() * basis;
    variance = basis * non_negative(weighted, squares.cwiseQuotient(floor));
  }
  return variance;
}

// Of Student's distribution: the half width of a 95 % interval over the standard error.
double quantile_95(Index freedom) {
  if (freedom < 1) return infinite;
  return boost::math::quantile(boost::math::students_t(static_cast<double>(freedom)), 0.975);
}

// Judges each free parameter by itself.
class Judge {
 public:
  Judge(const FitProblem& problem, const std::vector<double>& parameters, const Linearised& linearised,
        const Inverse& inverse, const std::vector<Polished>& rivals)
      : problem_(problem), parameters_(parameters), l_(linearised), inverse_(inverse), rivals_(rivals) {
    const auto freedom = l_.residual.size() - static_cast<Index>(l_.free.size());
    t_ = quantile_95(freedom);
    chance_ = freedom > 0 ? t_ * t_ / static_cast<double>(freedom) : infinite;
    find_valleys();
  }

  // Of free parameter j, with the standard error of the linearised model.
  [[nodiscard]] ParameterError95 judge(Index j, double standard_error) const {
    ParameterError95 error{standard_error, t_ * standard_error, false, ""};
    const double value = parameters_[l_.free[j]];
    if (!std::isfinite(t_)) return {infinite, infinite, false, "there are no more samples than parameters"};
    if (inverse_.blind[j] > most_blind) return {infinite, infinite, false, "the data do not tell it from others"};
    if (error.half_width > widest * std::abs(value)) {
      error.why_not = "its 95 % interval is wider than half its value";
    } else if (error.half_width > narrow * std::abs(value)) {
      const double up = rise_ratio(j, error.half_width);
      const double down = rise_ratio(j, -error.half_width);
      if (is_honest(up) && is_honest(down)) {
        const double correction = 0.5 * (1.0 / std::sqrt(up) + 1.0 / std::sqrt(down));
        error.standard_error *= correction;
        error.half_width *= correction;
      } else {
        error.why_not = "the error does not rise evenly around it";
      }
    }
    if (error.why_not.empty() && has_rival(j, error.half_width)) error.why_not = "other values, far away, fit as well";
    error.determined = error.why_not.empty();
    return error;
  }

 private:
  // The lowest of the rivals that are unlike each other and the best.
  void find_valleys() {
    const auto is_like = [&](const std::vector<double>& a, const std::vector<double>& b) {
      for (std::size_t k = 0; k < a.size(); ++k) {
        const FormParameter& p = problem_.parameters()[k];
        if (!p.is_linear && std::abs(coordinate_of(p, a[k]) - coordinate_of(p, b[k])) > other_valley) return false;
      }
      return true;
    };
    for (const Polished& r : rivals_) {
      if (valleys_.size() == most_valleys || rise(r.squares) > far_valley) break;
      const auto is_known = [&](const std::vector<double>& v) { return is_like(v, r.parameters); };
      if (!is_known(parameters_) && std::none_of(valleys_.begin(), valleys_.end(), is_known))
        valleys_.push_back(r.parameters);
    }
  }

  // Rise of the squares where the parameter is held `shift` away and the others are fitted again, from here and from
  // other valleys, over the rise that the linearised model foretells.
  [[nodiscard]] double rise_ratio(Index j, double shift) const {
    const std::size_t k = l_.free[j];
    const FormParameter& p = problem_.parameters()[k];
    const double held = parameters_[k] + shift;
    if (!(held >= p.least && held <= p.most)) return 0.0;
    double squares = squares_held(k, held, parameters_);
    for (const auto& valley : valleys_) squares = std::min(squares, squares_held(k, held, valley));
    const double scaled = shift * l_.length[j];
    return (squares - l_.residual.squaredNorm()) / (scaled * scaled / inverse_.matrix(j, j));
  }

  [[nodiscard]] double squares_held(std::size_t k, double held, std::vector<double> start) const {
    start[k] = held;
    return descend(problem_, start, {60, rise_accuracy * chance_}, static_cast<int>(k)).squares;
  }

  // Of the squares in another valley: relative, over that at the end of an interval.
  [[nodiscard]] double rise(double squares) const { return (squares / l_.residual.squaredNorm() - 1.0) / chance_; }

  [[nodiscard]] static bool is_honest(double ratio) { return ratio > 1.0 / honest_rise && ratio < honest_rise; }

  // Does another end, not much higher, have the parameter farther away than it can be in this valley?
  [[nodiscard]] bool has_rival(Index j, double half_width) const {
    const auto k = static_cast<std::size_t>(l_.free[j]);
    const double width = std::max(half_width, narrow * std::abs(parameters_[k]));
    return std::any_of(rivals_.begin(), rivals_.end(), [&](const Polished& r) {
      const double above = rise(r.squares);
      const double reach = above > 1.0 ? std::sqrt(honest_rise * above) : 1.0;
      return above <= far_valley && std::abs(r.parameters[k] - parameters_[k]) > reach * width;
    });
  }

  const FitProblem& problem_;
  const std::vector<double>& parameters_;
  const Linearised& l_;
  const Inverse& inverse_;
  const std::vector<Polished>& rivals_;
  std::vector<std::vector<double>> valleys_;
  double t_ = 0.0;
  double chance_ = 0.0;  // relative rise of the squares at the end of an interval, were noise the same everywhere
};

Eigen::MatrixXd correlation_of(const Linearised& l, const Inverse& inverse, const Eigen::MatrixXd& covariance,
                               Index size) {
  Eigen::MatrixXd correlation = Eigen::MatrixXd::Identity(size, size);
  for (Index j = 0; j < covariance.cols(); ++j)
    for (Index i = 0; i < j; ++i) {
      const double scale = std::sqrt(covariance(i, i) * covariance(j, j));
      if (!(scale > 0.0) || std::max(inverse.blind[i], inverse.blind[j]) > most_blind) continue;
      const double r = std::clamp(covariance(i, j) / scale, -1.0, 1.0);
      correlation(l.free[i], l.free[j]) = correlation(l.free[j], l.free[i]) = r;
    }
  return correlation;
}

}  // namespace

Uncertainty uncertainty(const FitProblem& problem, const std::vector<double>& parameters,
                        const std::vector<Polished>& rivals) {
  const auto size = static_cast<Index>(parameters.size());
  Uncertainty result;
  for (std::size_t k = 0; k < parameters.size(); ++k)
    result.parameters.push_back(
        {infinite, infinite, false,
         is_at_end(problem.parameters()[k], parameters[k]) ? "at the end of its range" : "it has no effect"});
  result.correlation = Eigen::MatrixXd::Identity(size, size);
  const Linearised l(problem, parameters);
  if (l.free.empty()) return result;
  const Inverse inverse(l.jacobian);
  const Eigen::VectorXd variance = variances(problem, parameters, l, inverse.matrix);
  const Eigen::MatrixXd covariance =
      inverse.matrix * (l.jacobian.transpose() * variance.asDiagonal() * l.jacobian) * inverse.matrix;
  const Judge judge(problem, parameters, l, inverse, rivals);
  for (Index j = 0; j < covariance.cols(); ++j)
    result.parameters[l.free[j]] = judge.judge(j, std::sqrt(covariance(j, j)) / l.length[j]);
  result.correlation = correlation_of(l, inverse, covariance, size);
  return result;
}

}  // namespace lrcs
