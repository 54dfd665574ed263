#pragma once
#include "bench/fit_method.h"

namespace lrcs {

// Ceres' Levenberg-Marquardt from so many places anywhere in the box, in the coordinates of fit/coordinate.h, bounded
// by the parameters' [least, most], exact derivatives, DENSE_QR, one thread. The starts: 100 iterations and Ceres'
// usual tolerances; the best of their ends goes on, 500 iterations, to the end.
[[nodiscard]] FitEnd ceres_starts(const FitTask& task, int starts);

}  // namespace lrcs
