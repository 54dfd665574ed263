#pragma once
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/large_pages.h"

namespace lrcs {

// Which of many things, known by their index, is equal to one: a hash table that holds indices only.
class IndexTable {
 public:
  // domain: at most so many indices are added.
  explicit IndexTable(std::size_t most) {
    const std::size_t size = std::bit_ceil(std::max<std::size_t>(2 * most, 2));
    reserve_large(places_, size);
    places_.assign(size, none);
    shift_ = 64 - std::countr_zero(places_.size());
  }

  // value: the index added before whose thing is equal; where there is none, `index`, which is added.
  // hash: equal for equal things; every bit of it counts. equal(k): is thing k equal to this one?
  template <class Equal>
  std::uint32_t first_equal(std::uint64_t hash, std::uint32_t index, const Equal& equal) {
    constexpr std::uint64_t golden = 0x9e3779b97f4a7c15U;  // 2^64 / golden ratio: spreads neighbours
    std::size_t at = hash * golden >> shift_;
    for (; places_[at] != none; at = (at + 1) & (places_.size() - 1))
      if (equal(places_[at])) return places_[at];
    return places_[at] = index;
  }

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  std::vector<std::uint32_t> places_;
  int shift_;
};

}  // namespace lrcs
