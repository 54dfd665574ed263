#include "base/compensated_sum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lrcs {
namespace {

TEST(CompensatedSum, KeepsWhatPlainAdditionLoses) {
  CompensatedSum sum;
  for (const double term : {1.0, 1e100, 1.0, -1e100}) sum.add(term);
  EXPECT_EQ(sum.value(), 2.0);
  EXPECT_EQ(CompensatedSum().value(), 0.0);
}

TEST(CompensatedSum, StaysWithinItsBoundOverRandomTerms) {
  std::mt19937 engine(51);
  std::uniform_real_distribution<double> term(-1.0, 1.0);
  CompensatedSum sum;
  long double exact = 0.0L;
  const int n = 100000;
  for (int k = 0; k < n; ++k) {
    const double x = term(engine);
    sum.add(x);
    exact += x;
  }
  const double u = std::ldexp(1.0, -53);
  const auto truth = static_cast<double>(exact);
  const double long_double_rounding = n * std::ldexp(1.0, -64) * 500.0;  // its partial sums stay below 500
  EXPECT_NEAR(sum.value(), truth, 2.0 * u * std::abs(truth) + 2.0 * n * u * u * n * n + long_double_rounding);
}

}  // namespace
}  // namespace lrcs
