#pragma once
#include <vector>

#include "fit/descent.h"

namespace lrcs {

// The last steps down to where the squares are least: Levenberg and Marquardt's method by Ceres with a QR
// factorisation, parameters at an end of their range held there. domain: a start that descend() found.
[[nodiscard]] Polished polish(const FitProblem& problem, const std::vector<double>& start);

}  // namespace lrcs
