#pragma once
#include <Eigen/Geometry>

#include "base/vec3.h"

namespace lrcs {

// Two directions; n = +z.
struct DirectionPair {
  Vec3 first, second;
};

// The pair whose half vector is at theta_h toward +x, and whose first direction is at (theta_d, phi_d) as seen from it.
// The second is the first mirrored at the half vector.
// source: S. Rusinkiewicz, A new change of variables for efficient BRDF representation, 1998.
[[nodiscard]] inline DirectionPair directions_of_half_difference(double theta_h, double theta_d, double phi_d) {
  const Vec3 half(std::sin(theta_h), 0.0, std::cos(theta_h));
  const Vec3 difference(std::sin(theta_d) * std::cos(phi_d), std::sin(theta_d) * std::sin(phi_d), std::cos(theta_d));
  const Vec3 first = Eigen::AngleAxisd(theta_h, Vec3::UnitY()) * difference;
  return {first, 2.0 * half.dot(first) * half - first};
}

}  // namespace lrcs
