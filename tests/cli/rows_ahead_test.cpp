#include "cli/rows_ahead.h"

#include <gtest/gtest.h>

#include <atomic>
#include <random>
#include <stdexcept>

namespace lrcs {
namespace {

TEST(RowsAhead, GivesTheRowAskedForWhereverOneJumps) {
  constexpr std::size_t rows = 20;
  RowsAhead ahead(
      [](std::size_t row) {
        if (row >= rows) throw std::out_of_range("row");
        FacetResult result;
        result.sigma_total_m2 = static_cast<double>(row);
        return result;
      },
      rows);
  for (const std::size_t row : {0, 1, 11, 12, 13, 12, 11, 10, 0, 1, 0, 19, 18, 19, 0, 1, 2, 2, 3})
    EXPECT_EQ(ahead.at(row).sigma_total_m2, static_cast<double>(row));
  std::mt19937 random(7);
  std::uniform_int_distribution<int> step(-2, 2);
  int row = 5;
  for (int k = 0; k < 500; ++k) {
    row = std::clamp(row + step(random), 0, static_cast<int>(rows) - 1);
    EXPECT_EQ(ahead.at(static_cast<std::size_t>(row)).sigma_total_m2, row);
  }
}

TEST(RowsAhead, ComputesTheNextRowOnceWhileOneGoesOn) {
  std::atomic<int> computed = 0;
  {
    RowsAhead ahead(
        [&](std::size_t) {
          ++computed;
          return FacetResult();
        },
        100);
    for (std::size_t row = 0; row <= 10; ++row) (void)ahead.at(row);
  }
  EXPECT_EQ(computed, 12);  // rows 0 to 11
}

}  // namespace
}  // namespace lrcs
