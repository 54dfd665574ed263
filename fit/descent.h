#pragma once
#include <vector>

#include "fit/fit_problem.h"

namespace lrcs {

// When to stop.
struct Patience {
  int iterations = 500;
  double function_tolerance = 1e-14;  // relative fall of the squares in one step from which on it is not worth while
};

struct Polished {
  std::vector<double> parameters;
  double squares = 0.0;  // sum of squared residuals
  int evaluations = 0;
  bool converged = false;
};

// Levenberg and Marquardt's method from a start, in the coordinates of fit/coordinate.h, within each parameter's
// [least, most], with exact derivatives. A parameter at an end of its range stays out of a step that would lead beyond:
// Ceres 2.1 takes the step and cuts it off, and crawls then (500 steps where 20 do). held: a parameter that keeps its
// value; -1: none.
[[nodiscard]] Polished descend(const FitProblem& problem, const std::vector<double>& start, const Patience& patience,
                               int held = -1);

}  // namespace lrcs
