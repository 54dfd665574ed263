#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace lrcs {

// A point [m] or a direction [1] in the target's body frame: x forward, y left, z up.
using Vec3 = Eigen::Vector3d;

inline constexpr double degree = std::numbers::pi / 180.0;  // [rad]

}  // namespace lrcs
