#pragma once
#include <vector>

#include "bench/fit_method.h"

namespace lrcs {

// Of pagmo, over the box of all parameters, with at most so many evaluations, seeded:
//   simulated annealing (Corana), temperature 1 to 1e-9 of E/100, 10 range adjustments of 20 steps a temperature;
//   self-adaptive differential evolution (de1220: variants by themselves, jDE), population 20;
//   CMA-ES, population 64, kept within the box.
// The last two go on until the budget is spent. Of nine parameters, 12 sets of data, better than sade with populations
// of 20 and 64 and two ways to adapt, than de1220 with 64, than CMA-ES with 16 or let out of the box; as good as with
// 200.
[[nodiscard]] std::vector<FitMethod> pagmo_methods(int evaluations);

}  // namespace lrcs
