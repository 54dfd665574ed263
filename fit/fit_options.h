#pragma once
#include <cstdint>

namespace lrcs {

// Genetic simulated annealing (fit/gsaa.h). domain: population >= 2, generations >= 0, crossover and mutation in [0,
// 1], cooling in (0, 1], step and temperature > 0.
struct GsaaOptions {
  int population = 64;
  int generations = 24;
  double crossover = 0.8;    // probability that an offspring has two parents
  double mutation = 0.25;    // probability that a coordinate of an offspring is moved
  double step = 0.3;         // of such a move at the first temperature [part of the search range]
  double temperature = 0.3;  // the first: a relative rise of the error that is accepted with probability 1/e [1]
  double cooling = 0.92;     // temperature of a generation over that of the one before
  std::uint64_t seed = 1;
};

// What is minimised.
enum class Residual {
  linear,      // f_r cos(theta_r), as in E
  logarithmic  // ln f_r: every decade counts the same
};

struct FitOptions {
  GsaaOptions gsaa;
  Residual residual = Residual::linear;
  int starts = 32;         // polishes from anywhere, besides those from the population's best
  int neighbours = 24;     // polishes from where one to three parameters of the best are moved anywhere
  int search_rows = 2000;  // the search looks at so many samples at most; the last polishes look at all
};

}  // namespace lrcs
