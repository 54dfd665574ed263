#include "mesh/weld.h"

#include <bit>
#include <unordered_map>

namespace lrcs {
namespace {

struct PositionHash {
  std::size_t operator()(const Vec3& p) const {
    std::uint64_t hash = 0;
    for (const double x : p) {
      hash ^= std::bit_cast<std::uint64_t>(x + 0.0);  // + 0.0: equal keys, equal hashes, for -0.0 too
      hash *= 0x9e3779b97f4a7c15U;                    // 2^64 / golden ratio: spreads neighbouring doubles
      hash ^= hash >> 32U;
    }
    return hash;
  }
};

}  // namespace

std::vector<std::uint32_t> first_equal(const std::vector<Vec3>& positions) {
  std::unordered_map<Vec3, std::uint32_t, PositionHash> known;
  known.reserve(positions.size());
  std::vector<std::uint32_t> first(positions.size());
  for (std::size_t k = 0; k < positions.size(); ++k)
    first[k] = known.try_emplace(positions[k], static_cast<std::uint32_t>(k)).first->second;
  return first;
}

}  // namespace lrcs
