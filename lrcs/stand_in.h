#pragma once
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/vec3.h"
#include "lrcs/facet_piece.h"

namespace lrcs {

// Corners (one a column) of the triangle with the middle and the second moments, over its area, of a region of a piece
// of a facet; of the piece itself, the piece. Rules over it are exact over the region for what varies quadratically.
// If no region has such second moments (rounding, or areas that outlines' bends have changed): like the piece, with the
// region's area and middle. Nothing if none has such a middle.
[[nodiscard]] inline std::optional<Eigen::Matrix<double, 2, 3>> stand_in_for(const AreaMoments& region,
                                                                             const FacetPiece& piece) {
  if (!(region.area > 0.0)) return std::nullopt;
  const Eigen::Vector2d middle = region.first / region.area, within = piece.within(middle);
  if (!(within.x() >= 0.0 && within.y() >= 0.0 && within.x() + within.y() <= 1.0)) return std::nullopt;
  const Eigen::Matrix2d spread = region.second / region.area - middle * middle.transpose();
  Eigen::Matrix<double, 2, 3> corners = piece.corners();
  corners.colwise() -= Eigen::Vector2d(corners.rowwise().mean());
  // No place lies further than `size` from any other, in either coordinate.
  if (!(spread.determinant() > 0.0 && spread(0, 0) > 0.0 && spread.trace() <= 0.5 * piece.size * piece.size)) {
    const double scale = std::sqrt(std::min(1.0, region.area / piece.area()));
    return Eigen::Matrix<double, 2, 3>((scale * corners).colwise() + middle);
  }
  const auto root = [](const Eigen::Matrix2d& m) {  // of a positive definite matrix
    const double determinant = std::sqrt(m.determinant());
    return Eigen::Matrix2d((m + determinant * Eigen::Matrix2d::Identity()) / std::sqrt(m.trace() + 2.0 * determinant));
  };
  // The unit triangle's.
  static const Eigen::Matrix2d from_triangle =
      root((Eigen::Matrix2d() << 1.0 / 18.0, -1.0 / 36.0, -1.0 / 36.0, 1.0 / 18.0).finished()).inverse();
  const Eigen::Matrix2d stretch = root(spread) * from_triangle / piece.size;
  return Eigen::Matrix<double, 2, 3>((stretch * corners).colwise() + middle);
}

}  // namespace lrcs
