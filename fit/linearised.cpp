#include "fit/linearised.h"

#include "fit/coordinate.h"

namespace lrcs {

Linearised::Linearised(const FitProblem& problem, const std::vector<double>& values) {
  using Eigen::Index;
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

}  // namespace lrcs
