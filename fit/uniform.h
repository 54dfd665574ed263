#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "base/splitmix64.h"

namespace lrcs {

// Numbers as if at random, the same for a seed on every machine.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : next_(splitmix64(seed + 1)) {}

  // In [0, 1).
  double next() { return static_cast<double>(splitmix64(next_++) >> 11U) * 0x1p-53; }
  // 0 .. count - 1.
  std::size_t below(std::size_t count) {
    return std::min(static_cast<std::size_t>(next() * static_cast<double>(count)), count - 1);
  }

 private:
  std::uint64_t next_;
};

}  // namespace lrcs
