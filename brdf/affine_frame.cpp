#include "brdf/affine_frame.h"

#include <algorithm>
#include <cmath>

namespace lrcs {
namespace {

// The part of the vector that the first axes do not hold.
Vec3 rest(const Vec3& vector, const Eigen::Matrix3d& axes, int known) {
  Vec3 left = vector;
  for (int k = 0; k < known; ++k) left -= axes.row(k).dot(left) * axes.row(k).transpose();
  return left;
}

// Any axes that complete the first ones.
void complete(Eigen::Matrix3d& axes, int known) {
  for (int k = known; k < 3; ++k) {
    Vec3 best = Vec3::Zero();
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 left = rest(Vec3::Unit(axis), axes, k);
      if (left.norm() > best.norm()) best = left;
    }
    axes.row(k) = best.normalized().transpose();
  }
}

}  // namespace

AffineFrame affine_frame(const std::vector<Vec3>& points, double tolerance) {
  AffineFrame frame;
  frame.origin = points.front();
  for (; frame.dimension < 3; ++frame.dimension) {
    const auto off = [&](const Vec3& p) { return rest(p - frame.origin, frame.axes, frame.dimension); };
    const auto farthest = std::max_element(points.begin(), points.end(), [&](const Vec3& a, const Vec3& b) {
      return off(a).squaredNorm() < off(b).squaredNorm();
    });
    const Vec3 along = off(*farthest);
    if (along.norm() <= tolerance) break;
    frame.axes.row(frame.dimension) = along.normalized().transpose();
  }
  const bool in_plane = std::all_of(points.begin(), points.end(), [](const Vec3& p) { return p.z() == 0.0; });
  if (frame.dimension == 3 || (frame.dimension == 2 && in_plane))
    return {frame.dimension, Vec3::Zero(), Eigen::Matrix3d::Identity()};
  complete(frame.axes, frame.dimension);
  return frame;
}

}  // namespace lrcs
