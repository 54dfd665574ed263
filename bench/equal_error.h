#pragma once
#include <string>
#include <vector>

#include "bench/measurement.h"

namespace lrcs {

// Of each relative accuracy asked of a target: the error reached beside what was asked, the bound over the error, and
// its time over that of the cheapest baseline at the same error: rays from facets, ray grids, z-buffers, each family
// interpolated between its methods (logarithms of time, of the shortest runs, and of root mean square error of sigma,
// metal-skin-5p).
// A baseline that is finer even at its coarsest counts with that; one that never gets there does not count.
// A line says so where an error passes its bound.
[[nodiscard]] std::string equal_error_text(const std::vector<Measurement>& of_target);

// The time of a curve at an error: the least of all its pieces that pass there; infinity where none does.
// domain: curve of (error, seconds), from coarse to fine; errors above 0.
struct WorkPrecision {
  double error = 0.0, seconds = 0.0;
};
[[nodiscard]] double seconds_at(double error, const std::vector<WorkPrecision>& curve);

}  // namespace lrcs
