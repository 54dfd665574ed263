#pragma once
#include <cmath>

#include "base/vec3.h"

namespace lrcs {

// Axes across a view, askew to those along which targets are designed: edges that run along rows of places are missed
// or met by all of a row, and rows along them had 2 to 20 times the error on tess, hubble and the spacecraft.
struct AskewAxes {
  Vec3 right, up;  // unit

  explicit AskewAxes(const Vec3& to_viewer) {
    const double askew = std::atan(2.0 / (1.0 + std::sqrt(5.0)));  // a slope far from all simple fractions
    right = Eigen::AngleAxisd(askew, to_viewer) * to_viewer.unitOrthogonal();
    up = to_viewer.cross(right);
  }
};

}  // namespace lrcs
