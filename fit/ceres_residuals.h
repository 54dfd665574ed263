#pragma once
#include <ceres/cost_function.h>

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "fit/coordinate.h"
#include "fit/fit_problem.h"

namespace lrcs {

// The residuals of a problem as Ceres asks for them, in the coordinates of fit/coordinate.h: one block of all
// parameters. Keeps a reference to the problem.
class CeresResiduals final : public ceres::CostFunction {
 public:
  explicit CeresResiduals(const FitProblem& problem) : problem_(problem) {
    set_num_residuals(static_cast<int>(problem.rows()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(problem.parameters().size()));
  }

  bool Evaluate(const double* const* coordinates, double* residuals, double** jacobians) const override {
    const auto parameters = problem_.parameters();
    std::vector<double> values(parameters.size());
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = value_at(parameters[k], coordinates[0][k]);
    Eigen::VectorXd residual;
    Eigen::MatrixXd jacobian;
    const bool wanted = jacobians != nullptr && jacobians[0] != nullptr;
    problem_.residuals(values, residual, wanted ? &jacobian : nullptr);
    if (!residual.allFinite()) return false;
    std::copy(residual.begin(), residual.end(), residuals);
    if (!wanted) return true;
    for (std::size_t k = 0; k < values.size(); ++k)
      jacobian.col(static_cast<Eigen::Index>(k)) *= slope_at(parameters[k], values[k]);
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Eigen::Map<Rows>(jacobians[0], jacobian.rows(), jacobian.cols()) = jacobian;
    return jacobian.allFinite();
  }

 private:
  const FitProblem& problem_;
};

}  // namespace lrcs
