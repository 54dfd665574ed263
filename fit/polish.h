#pragma once
#include <vector>

#include "fit/descent.h"

namespace lrcs {

// The last steps down to where the squares are least: Levenberg and Marquardt's method by Ceres with a QR
// factorisation, parameters at an end of their range held there. domain: a start that descend() found.
[[nodiscard]] Polished polish(const FitProblem& problem, const std::vector<double>& start);

// Whether the squares are least here as far as the linearised model tells: no step of the parameters that are not at an
// end of their range would lower them by a millionth, or they are rounding.
// source: D. Bates and D. Watts, Technometrics 23(2), 179, 1981.
[[nodiscard]] bool is_least(const FitProblem& problem, const std::vector<double>& parameters);

}  // namespace lrcs
