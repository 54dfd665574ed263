#pragma once
#include <algorithm>
#include <limits>

namespace lrcs {

// The range of the numbers taken so far; empty at first. domain: no NaN.
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void take(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] bool empty() const { return low > high; }
};

}  // namespace lrcs
