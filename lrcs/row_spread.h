#pragma once
#include <cmath>
#include <vector>

#include "lrcs/row_sums.h"

namespace lrcs {

// The sum of a grid's rows, and what it may be off by. unit: that of the rows.
struct RowTotal {
  double value = 0.0;
  double spread = 0.0;  // an estimate; falls with finer grids
  double doubt = 0.0;   // the rows', sure; does not
  [[nodiscard]] double bound() const { return spread + doubt; }
};

// The error is told from how neighbouring rows differ.
// value: spread = 2.5 sqrt(Sum (difference of neighbours)^2 / 2) + 4 largest. Were rows independent, the root would
//   be at least the standard deviation of the sum: what really changes from row to row adds to it. The second term is
//   for what no place has met: four places of the largest value that any has; for what returns more see UnmetReturns.
// error: an estimate; 2.5 is calibrated (docs/methods.md, section 7).
[[nodiscard]] inline RowTotal sum_of_rows(const std::vector<RowSum>& rows, double largest) {
  RowTotal total;
  double squares = 0.0, before = 0.0;
  for (const RowSum& row : rows) {
    total.value += row.value;
    total.doubt += row.doubt;
    squares += (row.value - before) * (row.value - before);
    before = row.value;
  }
  squares += before * before;
  constexpr double factor = 2.5, unmet = 4.0;
  total.spread = factor * std::sqrt(0.5 * squares) + unmet * largest;
  return total;
}

}  // namespace lrcs
