#include "base/expansion.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <random>

namespace lrcs {
namespace {

TEST(Expansion, HoldsSumsOfProductsExactly) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
  std::uniform_int_distribution<int> exponent(-60, 60);
  const auto any = [&] { return std::ldexp(mantissa(random), exponent(random)); };
  for (int round = 0; round < 1000; ++round) {
    Expansion<40> sum;
    mpq_class truth = 0;
    for (int k = 0; k < 20; ++k) {
      const double a = any(), b = any();
      sum.add_product(a, b);
      truth += mpq_class(a) * mpq_class(b);
    }
    mpq_class held = 0;
    for (std::size_t k = 0; k < sum.size(); ++k) held += mpq_class(sum[k]);
    ASSERT_EQ(held, truth);
    ASSERT_NEAR(sum.rounded(), truth.get_d(), 0x1p-52 * std::abs(truth.get_d()));
  }
}

TEST(Expansion, OfWhatCancelsIsZero) {
  Expansion<16> sum;
  for (const double term : {1e100, 1.0, 1e-100, 3.0}) sum.add(term);
  for (const double term : {1.0, 1e-100, 3.0, 1e100}) sum.add(-term);
  EXPECT_EQ(sum.size(), 0U);
  EXPECT_EQ(sum.rounded(), 0.0);
}

}  // namespace
}  // namespace lrcs
