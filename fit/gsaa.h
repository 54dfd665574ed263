#pragma once
#include <functional>
#include <span>
#include <vector>

#include "fit/fit_options.h"

namespace lrcs {

// A place in the unit cube and its error.
struct Candidate {
  std::vector<double> place;
  double error = 0.0;
};

// Genetic simulated annealing of error(place) over the unit cube of `dimensions`: the last population and the best
// ever, best first. Each generation every individual gets an offspring (two parents by tournament, blended crossover,
// mutation) that takes its place by Metropolis' rule on the relative rise of the error; then the temperature falls.
// laws: the same seed gives the same bytes. error(place) is called population (generations + 1) times, in order.
// source: the scheme of Wang and Wu, Infrared and Laser Engineering 43(1), 332, 2014.
[[nodiscard]] std::vector<Candidate> gsaa(std::size_t dimensions, const GsaaOptions& options,
                                          const std::function<double(std::span<const double>)>& error);

}  // namespace lrcs
