#pragma once
#include <vector>

#include "base/vec3.h"

namespace lrcs {

// The point, line, plane or space that a set of points fills.
struct AffineFrame {
  int dimension = 0;
  Vec3 origin = Vec3::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // rows: unit, orthogonal, the first `dimension` along it

  // Coordinates in the frame; those past the dimension are the distances from it.
  [[nodiscard]] Vec3 local(const Vec3& point) const { return axes * (point - origin); }
};

// Of the fewest dimensions that hold every point to within the tolerance.
// laws: space, and the plane z = 0, keep their axes and the origin: coordinates there stay as they are.
// domain: at least one point.
[[nodiscard]] AffineFrame affine_frame(const std::vector<Vec3>& points, double tolerance);

}  // namespace lrcs
