#pragma once
#include "base/estimate.h"
#include "brdf/brdf.h"

namespace lrcs {

// Directional-hemispherical reflectance [1]: the part of the light from theta_i that goes anywhere.
// value: Integral of f_r cos(theta_r) over the hemisphere of wr. Energy is conserved where it is at most 1.
// domain: theta_i in [0, pi/2) [rad], relative > 0; else std::domain_error.
// error: bound is the sum, over the cells of an adaptive cubature, of the differences of a 15- and a 7-point rule in
//        theta and in phi, plus rounding. It holds where the cells resolve f_r (no lobe narrower than a cell's points);
//        of a tabulated BRDF, which has kinks, it is an estimate that may be twice too small.
//        It ends below relative * value, or where max_cells is reached, at whatever it is then.
// check: Lambert: the reflectance. tests/brdf/albedo_test.cpp
[[nodiscard]] Estimate albedo(const Brdf& brdf, double theta_i, double relative = 1e-6);

}  // namespace lrcs
