#pragma once
#include <vector>

#include "bench/fit_method.h"

namespace lrcs {

// Of pagmo, over the box of all parameters, with at most so many evaluations, seeded:
//   simulated annealing (Corana), temperature 1 to 1e-9 of E/100, 10 range adjustments of 20 steps a temperature;
//   self-adaptive differential evolution (jDE, rand/1/exp) and CMA-ES, population 64, going on until the budget is
//   spent.
[[nodiscard]] std::vector<FitMethod> pagmo_methods(int evaluations);

}  // namespace lrcs
