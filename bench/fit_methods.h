#pragma once
#include <vector>

#include "bench/fit_method.h"
#include "fit/uniform.h"

namespace lrcs {

// The methods that are compared, lrcs' first:
//   lrcs search            search(), defaults: fit/search.h
//   lrcs fit               fit_brdf(): what `lrcs fit` does. Nine parameters: a search for five, search() from there
//   too,
//                          the last polish, the parameters' errors
//   GSAA, all parameters   gsaa() over the box, population 64, no polish: after Wang and Wu 2014
//   pagmo ...              bench/pagmo_methods.h
//   Ceres, N starts        bench/ceres_starts.h
[[nodiscard]] std::vector<FitMethod> fit_methods(const FitBudget& budget);

// Levenberg and Marquardt's method once: descend() from anywhere in the box, the linear parameters solved for first.
[[nodiscard]] FitEnd one_descent(const FitBox& box, Uniform& random);

}  // namespace lrcs
