#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "bench/fit_method.h"

namespace lrcs {

// One run of one method on one set of data.
struct FitRun {
  std::string method;
  double noise = 0.0;
  double seconds = 0.0;  // of processor time
  long evaluations = 0;
  double squares = 0.0;   // sum of squared residuals [E/100]
  double polished = 0.0;  // the same after one descend() from there, which is in no time or evaluations
  double best = 0.0;      // the least that any method found on these data
};

// All methods on one set of data.
struct FitComparison {
  std::vector<FitRun> runs;     // the methods' in their order, then one for each descent from anywhere
  bool box_holds_best = false;  // the box in which methods without derivatives look
  bool truth_is_best = false;   // the best lies no lower than where a descent from the truth ends
};

inline constexpr std::string_view one_descent_name = "one descent";

// The best known: the least of what all methods end at, polished or not, of `reference` descents from anywhere, and of
// one from the true parameters.
[[nodiscard]] FitComparison compare_fits(const std::vector<FitMethod>& methods, const std::string& form,
                                         const FitData& data, int reference);

// Whether squares are at most 1.001 times the best, or E at most 1e-10 %: the data have no noise, and are met exactly.
[[nodiscard]] bool is_success(double squares, double best);

}  // namespace lrcs
