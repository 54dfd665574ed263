#pragma once
#include <Eigen/Core>

namespace lrcs {

// Non-negative least squares in two unknowns.
// value: the c with c[0], c[1] >= 0 for which |columns c - target| is least: the free solution, or the better of the
// two
//   with one unknown at 0.
[[nodiscard]] Eigen::Vector2d non_negative_pair(const Eigen::MatrixX2d& columns, const Eigen::VectorXd& target);

}  // namespace lrcs
