#pragma once
#include <array>
#include <cmath>
#include <cstddef>

namespace lrcs {

// The real number value + error; value is it rounded.
struct Unrounded {
  double value;
  double error;
};

// law: exact unless it overflows.
[[nodiscard]] inline Unrounded sum_of(double a, double b) {
  const double value = a + b;
  const double b_part = value - a;
  return {value, (a - (value - b_part)) + (b - b_part)};
}

// law: exact unless it over- or underflows. std::fma is exact with and without the instruction.
[[nodiscard]] inline Unrounded product_of(double a, double b) {
  const double value = a * b;
  return {value, std::fma(a, b, -value)};
}

// A real number held exactly as a sum of doubles that do not overlap, smallest first; zero has none.
// Capacity: the most terms it can take; the caller knows how many are added.
// domain: neither over- nor underflow in what is added. check: tests/base/expansion_test.cpp against rationals.
// source: T. J. Dekker, Numer. Math. 18, 224-242, 1971; J. R. Shewchuk, Discrete Comput. Geom. 18, 305-363, 1997.
template <std::size_t Capacity>
class Expansion {
 public:
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] double operator[](std::size_t k) const { return parts_[k]; }

  void add(double term) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < size_; ++k) {
      const Unrounded sum = sum_of(term, parts_[k]);
      if (sum.error != 0.0) parts_[kept++] = sum.error;
      term = sum.value;
    }
    if (term != 0.0) parts_[kept++] = term;
    size_ = kept;
  }
  void add_product(double a, double b) {
    const Unrounded product = product_of(a, b);
    if (product.error != 0.0) add(product.error);
    if (product.value != 0.0) add(product.value);
  }
  // error: one unit in the last place; zero only if the number is zero.
  [[nodiscard]] double rounded() const {
    double total = 0.0;
    for (std::size_t k = 0; k < size_; ++k) total += parts_[k];
    return total;
  }

 private:
  std::array<double, Capacity> parts_;  // the first size_ hold values
  std::size_t size_ = 0;
};

}  // namespace lrcs
