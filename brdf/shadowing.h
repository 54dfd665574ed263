#pragma once
#include <optional>

#include "brdf/brdf.h"

namespace lrcs {

// The shadowing function G [1] of models that have one (Wu); nothing of the others.
// frame: angles as in f_r_angles. domain: G is 0 where either direction is not above the surface.
// check: tests/brdf/shadowing_test.cpp.
[[nodiscard]] std::optional<double> shadowing_angles(const Brdf& brdf, double theta_i, double theta_r, double phi);

}  // namespace lrcs
