#include "base/bucket_sort.h"

#include <gtest/gtest.h>

#include <random>
#include <utility>

namespace lrcs {
namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

// Law: the same as std::sort, whether numbers lie close together, far apart, or are all the same.
TEST(BucketSort, SortsAsStdSortDoes) {
  std::mt19937 random(1);
  for (const std::uint32_t most : {0U, 3U, 1000U, 4000000000U})
    for (const std::size_t count : {0U, 1U, 2U, 1000U}) {
      std::uniform_int_distribution<std::uint32_t> number(most / 2, most), other;
      std::vector<Pair> values;
      for (std::size_t k = 0; k < count; ++k) values.emplace_back(number(random), other(random));
      auto sorted = values;
      std::sort(sorted.begin(), sorted.end());
      const auto in_buckets = bucket_sorted<Pair>(
          [&](const auto& put) { std::for_each(values.begin(), values.end(), put); },
          [](const Pair& p) { return p.first; }, [](const Pair& p, const Pair& q) { return p.second < q.second; });
      EXPECT_EQ(in_buckets, sorted) << most << " " << count;
    }
}

}  // namespace
}  // namespace lrcs
