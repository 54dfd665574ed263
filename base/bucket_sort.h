#pragma once
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/large_pages.h"

namespace lrcs {

// Values in the order of a whole number that each has, and those of equal number in that of `less`.
// for_each(put): calls put(value) for every one, each time in the same order; it is asked three times, so that the
// values are in memory once. less: tells any two of equal number apart; it is called from several threads. cost: O(n)
// where few share a number and the numbers lie within a few n of each other; else that of std::sort.
template <class T, class ForEach, class Number, class Less>
[[nodiscard]] std::vector<T> bucket_sorted(const ForEach& for_each, const Number& number, const Less& less) {
  std::size_t count = 0, first = 0, last = 0;
  for_each([&](const T& value) {
    const std::size_t n = number(value);
    first = count == 0 ? n : std::min(first, n);
    last = std::max(last, n);
    ++count;
  });
  std::vector<T> sorted;
  if ((last - first) / 4 > count) {
    sorted.reserve(count);
    for_each([&](const T& value) { sorted.push_back(value); });
    std::sort(sorted.begin(), sorted.end(),
              [&](const T& a, const T& b) { return number(a) != number(b) ? number(a) < number(b) : less(a, b); });
    return sorted;
  }
  std::vector<std::size_t> end = large_vector<std::size_t>(last - first + 2);
  for_each([&](const T& value) { ++end[number(value) - first + 1]; });
  for (std::size_t k = 1; k < end.size(); ++k) end[k] += end[k - 1];
  sorted = large_vector<T>(count);
  for_each([&](const T& value) { sorted[end[number(value) - first]++] = value; });
  // Now end[k] is the end of bucket k, and the begin of the next.
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, end.size() - 1, 1024), [&](const auto& buckets) {
    for (std::size_t k = buckets.begin(); k < buckets.end(); ++k)
      std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(k == 0 ? 0 : end[k - 1]),
                sorted.begin() + static_cast<std::ptrdiff_t>(end[k]), less);
  });
  return sorted;
}

}  // namespace lrcs
