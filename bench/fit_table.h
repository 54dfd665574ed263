#pragma once
#include <string>
#include <vector>

#include "bench/fit_comparison.h"

namespace lrcs {

// A method over all sets of data.
struct FitSummary {
  std::string method;
  double seconds = 0.0;            // median
  double evaluations = 0.0;        // median
  double success = 0.0;            // share of runs [1]
  std::vector<double> success_at;  // the same for each noise
  double success_polished = 0.0;   // the same after one descend() from where it ended
  double worst_ratio = 1.0;        // of squares over the best, where the best is not exact
};

// In the order of the methods.
[[nodiscard]] std::vector<FitSummary> fit_summaries(const std::vector<FitComparison>& comparisons,
                                                    const std::vector<double>& noises);

// The table as printed, with its head and what stands below it.
[[nodiscard]] std::string fit_table_text(const std::string& form, const std::vector<FitComparison>& comparisons,
                                         const std::vector<double>& noises);

// A sentence each: where lrcs misses its bars, a success of 100 % and a median time of at most 0.5 s.
[[nodiscard]] std::vector<std::string> missed_bars(const std::vector<FitSummary>& summaries);

}  // namespace lrcs
