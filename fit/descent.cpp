#include "fit/descent.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/coordinate.h"

namespace lrcs {
namespace {

using Index = Eigen::Index;

class Descent {
 public:
  Descent(const FitProblem& problem, const std::vector<double>& start, const Patience& patience, int held)
      : problem_(problem), patience_(patience), held_(held), values_(start) {
    const auto parameters = problem.parameters();
    const auto size = static_cast<Index>(parameters.size());
    place_.resize(size), low_.resize(size), high_.resize(size);
    for (Index k = 0; k < size; ++k) {
      const FormParameter& p = parameters[k];
      low_[k] = coordinate_of(p, p.least);
      high_[k] = coordinate_of(p, p.most);
      values_[k] = std::clamp(values_[k], p.least, p.most);
      place_[k] = coordinate_of(p, values_[k]);
    }
  }

  Polished run() {
    linearise();
    int count = 0;
    bool converged = false;
    while (count < patience_.iterations && !converged && damping_ < 1e20) {
      ++count;
      converged = !step();
    }
    return {values_, squares_, evaluations_, converged || damping_ >= 1e20};
  }

 private:
  void linearise() {
    problem_.residuals(values_, residual_, &jacobian_);
    ++evaluations_;
    squares_ = residual_.squaredNorm();
    for (Index k = 0; k < place_.size(); ++k) jacobian_.col(k) *= slope_at(problem_.parameters()[k], values_[k]);
    gradient_.noalias() = jacobian_.transpose() * residual_;
    products_.noalias() = jacobian_.transpose() * jacobian_;
    if (largest_.size() == 0) largest_ = products_.diagonal();
    largest_ = largest_.cwiseMax(products_.diagonal());
  }

  [[nodiscard]] bool stays(Index k) const {
    return k == held_ || (place_[k] <= low_[k] && gradient_[k] >= 0.0) ||
           (place_[k] >= high_[k] && gradient_[k] <= 0.0);
  }

  // The damped step of those parameters that are free, cut off at the ends of their ranges.
  [[nodiscard]] Eigen::VectorXd damped_step() const {
    Eigen::MatrixXd a = products_;
    Eigen::VectorXd b = -gradient_;
    for (Index k = 0; k < place_.size(); ++k) {
      a(k, k) += damping_ * largest_[k] + std::numeric_limits<double>::min();
      if (!stays(k)) continue;
      a.row(k).setZero();
      a.col(k).setZero();
      a(k, k) = 1.0;
      b[k] = 0.0;
    }
    const Eigen::VectorXd there = (place_ + a.ldlt().solve(b)).cwiseMax(low_).cwiseMin(high_);
    return there - place_;
  }

  // False where it is not worth while to go on.
  bool step() {
    const Eigen::VectorXd way = damped_step();
    const double promised = -way.dot(2.0 * gradient_ + products_ * way);
    if (!(promised > 0.0)) return grow_damping(way.isZero(0.0));
    std::vector<double> there(values_.size());
    for (std::size_t k = 0; k < there.size(); ++k)
      there[k] = value_at(problem_.parameters()[k], place_[static_cast<Index>(k)] + way[static_cast<Index>(k)]);
    Eigen::VectorXd residual;
    problem_.residuals(there, residual, nullptr);
    ++evaluations_;
    const double fall = squares_ - residual.squaredNorm();
    if (!(fall > 0.0)) return grow_damping(promised <= patience_.function_tolerance * squares_);
    const double before = squares_;
    place_ += way;
    values_ = there;
    linearise();
    const double honesty = std::min(fall / promised, 1.0);
    damping_ *= std::max(1.0 / 3.0, 1.0 - std::pow(2.0 * honesty - 1.0, 3.0));
    growth_ = 2.0;
    return fall > patience_.function_tolerance * before || promised > patience_.function_tolerance * before;
  }

  bool grow_damping(bool give_up) {
    damping_ *= growth_;
    growth_ *= 2.0;
    return !give_up;
  }

  const FitProblem& problem_;
  const Patience& patience_;
  Index held_;
  std::vector<double> values_;
  Eigen::VectorXd place_, low_, high_, residual_, gradient_, largest_;
  Eigen::MatrixXd jacobian_, products_;
  double squares_ = 0.0, damping_ = 1e-3, growth_ = 2.0;
  int evaluations_ = 0;
};

}  // namespace

Polished descend(const FitProblem& problem, const std::vector<double>& start, const Patience& patience, int held) {
  return Descent(problem, start, patience, held).run();
}

}  // namespace lrcs
