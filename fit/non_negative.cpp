#include "fit/non_negative.h"

#include <Eigen/QR>
#include <algorithm>
#include <vector>

namespace lrcs {

Eigen::VectorXd non_negative(const Eigen::MatrixXd& columns, const Eigen::VectorXd& target) {
  using Eigen::Index;
  const Eigen::VectorXd length = columns.colwise().norm();
  const Eigen::VectorXd scale = (length.array() > 0.0).select(length.cwiseInverse(), 0.0);
  const Eigen::MatrixXd even = columns * scale.asDiagonal();
  // |columns c - target|^2 less |target|^2, through a triangle as small as the unknowns are few.
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(even);
  const Index rank = std::min(even.rows(), even.cols());
  const Eigen::MatrixXd triangle = qr.matrixQR().topRows(rank).triangularView<Eigen::Upper>();
  const Eigen::VectorXd turned = (qr.householderQ().adjoint() * target).head(rank);
  Eigen::VectorXd best = Eigen::VectorXd::Zero(columns.cols());
  double least = turned.squaredNorm();
  for (unsigned set = 1; set < 1U << static_cast<unsigned>(columns.cols()); ++set) {
    std::vector<Index> members;
    for (Index k = 0; k < columns.cols(); ++k)
      if ((set >> static_cast<unsigned>(k) & 1U) != 0U) members.push_back(k);
    const Eigen::MatrixXd some = triangle(Eigen::all, members);
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(some);
    if (solver.rank() < some.cols()) continue;
    const Eigen::VectorXd c = solver.solve(turned);
    const double squares = (some * c - turned).squaredNorm();
    if (!(c.minCoeff() >= 0.0) || !(squares < least)) continue;
    least = squares;
    best.setZero();
    best(members) = c;
  }
  return best.cwiseProduct(scale);
}

}  // namespace lrcs
