#pragma once
#include <cmath>

#include "base/expansion.h"

namespace lrcs {

// p q - r s to twice the digits of a double, rounded.
struct ProductDifference {
  double value;
  double least;  // value is right to less than half a unit where it is this much at least: else too much has cancelled
};

// pq, rs: the products of the leading parts, exact. error: below 2^-100 of the products. No branch, for loops that are
// to become vector code.
[[nodiscard]] inline ProductDifference product_difference(const Unrounded& p, const Unrounded& q, const Unrounded& r,
                                                          const Unrounded& s, const Unrounded& pq,
                                                          const Unrounded& rs) {
  const Unrounded leading = sum_of(pq.value, -rs.value);
  const double cross_terms = (p.value * q.error + p.error * q.value) - (r.value * s.error + r.error * s.value);
  constexpr double worst_cancellation = 0x1p-46;
  return {leading.value + (leading.error + ((pq.error - rs.error) + cross_terms)),
          worst_cancellation * (std::abs(pq.value) + std::abs(rs.value))};
}

}  // namespace lrcs
