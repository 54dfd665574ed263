#pragma once
#include <cmath>

namespace lrcs {

// Sum of doubles in the order given, with the rounding errors carried along.
// error: at most 2 u |sum| + 2 n^2 u^2 Sum |terms|, u = 2^-53.
// source: A. Neumaier, Z. Angew. Math. Mech. 54(1), 39-51, 1974, algorithm IV.
class CompensatedSum {
 public:
  void add(double term) {
    const double sum = sum_ + term;
    carry_ += std::abs(sum_) >= std::abs(term) ? (sum_ - sum) + term : (term - sum) + sum_;
    sum_ = sum;
  }
  [[nodiscard]] double value() const { return sum_ + carry_; }

 private:
  double sum_ = 0.0;
  double carry_ = 0.0;
};

}  // namespace lrcs
