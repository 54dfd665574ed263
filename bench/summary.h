#pragma once
#include <string>
#include <vector>

#include "bench/measurement.h"

namespace lrcs {

// A method on a target: the median over its directions of the medians over the runs, and root mean square errors.
struct Summary {
  std::string target;
  std::size_t facets = 0;
  std::string family, method, mark;
  double seconds = 0.0;
  double least_seconds = 0.0;  // the same of the shortest runs: other load only adds
  double over_one_ray = 0.0;   // its time over that of one Embree ray a front facet, in the same direction
  SeenSums error;
  SeenSums largest_error;  // over the directions
};

// Of one target, in the order of the methods.
[[nodiscard]] std::vector<Summary> summaries(const std::vector<Measurement>& of_target);

// domain: not empty.
[[nodiscard]] double root_mean_square(const std::vector<double>& values);

// The table as printed, with its head.
[[nodiscard]] std::string table_text(const std::vector<Summary>& of_target);

}  // namespace lrcs
