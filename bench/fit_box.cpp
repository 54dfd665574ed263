#include "bench/fit_box.h"

#include <algorithm>
#include <cmath>

#include "fit/coordinate.h"

namespace lrcs {

FitBox::FitBox(const FitProblem& problem, const std::vector<BrdfSample>& samples) : problem_(problem) {
  for (const BrdfSample& s : samples) most_linear_ = std::max(most_linear_, 2.0 * s.f_r * std::cos(s.theta_r));
}

std::vector<double> FitBox::values_at_place(std::span<const double> place) const {
  const auto parameters = problem_.parameters();
  std::vector<double> values(parameters.size());
  for (std::size_t k = 0; k < values.size(); ++k)
    values[k] = value_at(parameters[k], parameters[k].is_linear ? most_linear_ * place[k] : place[k]);
  return values;
}

bool FitBox::holds(const std::vector<double>& values) const {
  const auto parameters = problem_.parameters();
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double end = parameters[k].is_linear ? most_linear_ : 1.0;
    const double coordinate = coordinate_of(parameters[k], values[k]);
    if (!(coordinate >= 0.0 && coordinate <= end)) return false;
  }
  return true;
}

double FitBox::squares(const std::vector<double>& values) const {
  Eigen::VectorXd residual;
  problem_.residuals(values, residual, nullptr);
  const double sum = residual.squaredNorm();
  return std::isfinite(sum) ? sum : 1e100;
}

}  // namespace lrcs
