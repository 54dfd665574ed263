#pragma once
#include <cstddef>
#include <functional>
#include <future>
#include <utility>

#include "view/facet_result.h"

namespace lrcs {

// What facets do in rows of a sweep that is gone through: while one row is looked at, the next one the same way is
// computed in a thread of its own.
class RowsAhead {
 public:
  using Compute = std::function<FacetResult(std::size_t row)>;
  // compute: safe to call from two threads at once.
  RowsAhead(Compute compute, std::size_t rows) : compute_(std::move(compute)), rows_(rows) {}

  [[nodiscard]] FacetResult at(std::size_t row) {
    FacetResult result = ahead_.valid() && ahead_row_ == row ? ahead_.get() : compute_(row);
    ahead_ = {};
    const bool goes_up = row == last_ + 1, goes_down = row + 1 == last_;
    last_ = row;
    if ((goes_up && row + 1 < rows_) || (goes_down && row > 0)) {
      ahead_row_ = goes_up ? row + 1 : row - 1;
      ahead_ = std::async(std::launch::async, compute_, ahead_row_);
    }
    return result;
  }

 private:
  Compute compute_;
  std::size_t rows_, last_ = 0;
  std::size_t ahead_row_ = 0;  // of ahead_, where that is valid
  std::future<FacetResult> ahead_;
};

}  // namespace lrcs
