#pragma once
#include <cstdint>

namespace lrcs {

// Number k of a sequence of 64 bits as if at random. source: S. Vigna's splitmix64, seed 0, its first number at k = 1.
[[nodiscard]] inline std::uint64_t splitmix64(std::uint64_t k) {
  std::uint64_t z = k * 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

}  // namespace lrcs
