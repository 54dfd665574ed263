#pragma once
#include <Eigen/Core>
#include <vector>

#include "fit/fit_problem.h"

namespace lrcs {

// The residuals at a place [1], and their derivatives in the parameters that can move there: not at an end of their
// range, and not without effect. The measure of length is the residuals', whatever the parameters' units.
struct Linearised {
  std::vector<Eigen::Index> free;  // numbers of the parameters that can move, rising
  Eigen::VectorXd residual;
  Eigen::VectorXd length;    // of a free parameter's derivative [1/unit of the parameter]
  Eigen::MatrixXd jacobian;  // a column a free parameter, of length 1

  Linearised(const FitProblem& problem, const std::vector<double>& values);
};

}  // namespace lrcs
