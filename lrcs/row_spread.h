#pragma once
#include <cmath>
#include <vector>

#include "base/estimate.h"
#include "lrcs/row_sums.h"

namespace lrcs {

// The sum of a grid's rows, and a bound of its error told from how neighbouring rows differ.
// value: bound = 2 [sqrt(Sum (difference of neighbours)^2 / 2) + 2 largest] + doubt. Were rows independent, the root
//   would be at least the standard deviation of the sum: what really changes from row to row adds to it. The second
//   term is for what no place has met: two places of the largest value. The factor is calibrated: among 2,160 grids of
//   9 targets, 6 sizes and 40 directions the error never was more than 1.09 brackets, the median 0.17.
// unit: that of the rows.
[[nodiscard]] inline Estimate sum_of_rows(const std::vector<RowSum>& rows, double largest) {
  double sum = 0.0, doubt = 0.0, squares = 0.0, before = 0.0;
  for (const RowSum& row : rows) {
    sum += row.value;
    doubt += row.doubt;
    squares += (row.value - before) * (row.value - before);
    before = row.value;
  }
  squares += before * before;
  constexpr double factor = 2.0, unmet = 2.0;
  return {sum, factor * (std::sqrt(0.5 * squares) + unmet * largest) + doubt};
}

}  // namespace lrcs
