#pragma once
#include <Eigen/Core>

namespace lrcs {

// Non-negative least squares of few unknowns.
// value: the c >= 0 for which |columns c - target| is least: the best of the free solutions of all sets of columns that
//   are not negative. Of columns that depend on others, some are left out. domain: at most 8 columns.
[[nodiscard]] Eigen::VectorXd non_negative(const Eigen::MatrixXd& columns, const Eigen::VectorXd& target);

}  // namespace lrcs
