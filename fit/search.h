#pragma once
#include "fit/fit_options.h"
#include "fit/polish.h"

namespace lrcs {

// The parameters whose residuals have the least squares, sought over all of the parameters' ranges.
// Genetic simulated annealing over the parameters that are not linear, the linear ones solved for each time; then the
// best and most unlike of its last population, places anywhere, and the best with some of its parameters moved (one to
// either end of its range, or one to three anywhere) are polished; last the best few to the end.
// Why so much: nine parameters leave flat valleys and side valleys of nearly the same depth. One polish from anywhere
// ends in the deepest in 32 of 100 cases (docs/fitting.md).
// start: further places to polish from, all parameters given: the fit of a model that this one contains.
// laws: the same bytes for the same seed.
struct Found : Polished {
  std::vector<Polished> rivals;  // where other polishes ended with squares of at most twice the least, least first
};
[[nodiscard]] Found search(const FitProblem& problem, const FitOptions& options,
                           const std::vector<std::vector<double>>& starts = {});

}  // namespace lrcs
