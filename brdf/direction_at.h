#pragma once
#include <cmath>

#include "base/vec3.h"

namespace lrcs {

// The unit vector at theta from the normal z, phi from x [rad].
[[nodiscard]] inline Vec3 direction_at(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

}  // namespace lrcs
