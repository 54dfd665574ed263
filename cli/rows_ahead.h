#pragma once
#include <cstddef>
#include <functional>
#include <future>

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
    FacetResult result = next_.valid() && next_row_ == row ? next_.get() : compute_(row);
    const bool goes_on = row == last_ + 1 || row + 1 == last_;
    next_row_ = row > last_ ? row + 1 : row - 1;
    if (goes_on && next_row_ < rows_) next_ = std::async(std::launch::async, compute_, next_row_);
    last_ = row;
    return result;
  }

 private:
  Compute compute_;
  std::size_t rows_, last_ = 0, next_row_ = 0;
  std::future<FacetResult> next_;
};

}  // namespace lrcs
