#include "mesh/weld.h"

#include <bit>

#include "base/large_pages.h"
#include "mesh/index_table.h"

namespace lrcs {
namespace {

std::uint64_t hash_of(const Vec3& p) {
  std::uint64_t hash = 0;
  for (const double x : p) {
    hash ^= std::bit_cast<std::uint64_t>(x + 0.0);  // + 0.0: equal keys, equal hashes, for -0.0 too
    hash *= 0x9e3779b97f4a7c15U;                    // 2^64 / golden ratio: spreads neighbouring doubles
    hash ^= hash >> 32U;
  }
  return hash;
}

}  // namespace

std::vector<std::uint32_t> first_equal(const std::vector<Vec3>& positions) {
  IndexTable known(positions.size());
  std::vector<std::uint32_t> first = large_vector<std::uint32_t>(positions.size());
  for (std::uint32_t k = 0; k < positions.size(); ++k)
    first[k] = known.first_equal(hash_of(positions[k]), k,
                                 [&](std::uint32_t other) { return positions[other] == positions[k]; });
  return first;
}

std::vector<std::uint32_t> keep_different(std::vector<Vec3>& positions) {
  std::vector<std::uint32_t> place = first_equal(positions);
  std::uint32_t kept = 0;
  for (std::size_t k = 0; k < place.size(); ++k) {
    if (place[k] == k) {
      positions[kept] = positions[k];
      place[k] = kept++;
    } else {
      place[k] = place[place[k]];
    }
  }
  positions.resize(kept);
  return place;
}

}  // namespace lrcs
