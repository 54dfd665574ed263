#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "base/compensated_sum.h"
#include "base/vec3.h"

namespace lrcs {

// Facets a block: as many lanes are summed side by side, whatever the machine's vectors hold.
inline constexpr std::size_t block_facets = 64;

using BlockArray = std::array<double, block_facets>;

// Facets of one material as arrays, small enough to stay in the nearest cache while directions pass over it.
// Unused places have area 0 and no normal.
struct alignas(64) FacetBlock {
  BlockArray nx{}, ny{}, nz{};                   // unit normals
  BlockArray area{};                             // [m^2]
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  // box of the normals
  std::uint32_t material = 0;
  std::uint32_t facets = 0;

  // The cosine of a facet as every loop over a block computes it.
  [[nodiscard]] double cosine(std::size_t k, const Vec3& d) const {
    return nx[k] * d.x() + ny[k] * d.y() + nz[k] * d.z();
  }
  [[nodiscard]] Vec3 normal(std::size_t k) const { return {nx[k], ny[k], nz[k]}; }
  // law: least(d) <= cosine(k, d) <= most(d), rounding included, which is monotone.
  [[nodiscard]] double most(const Vec3& d) const {
    return std::max(low.x() * d.x(), high.x() * d.x()) + std::max(low.y() * d.y(), high.y() * d.y()) +
           std::max(low.z() * d.z(), high.z() * d.z());
  }
  [[nodiscard]] double least(const Vec3& d) const { return -most(-d); }
};

// Sums for one direction over a few blocks, a lane for each place in a block. Only positive numbers are added.
struct alignas(64) LaneSums {
  BlockArray returned{};  // f_r cos_i cos_r A
  BlockArray seen{};      // cos_r A
  BlockArray slope{};     // f_r cos_i cos_r A / min(cos_i, cos_r): what the bound goes by
};

// Sums of LaneSums, lane by lane: lane k is value[k] + rest[k], rest carrying the rounding errors (Knuth's two-sum).
struct alignas(64) CarriedLanes {
  BlockArray value{}, rest{};

  void add(const BlockArray& terms) {
    for (std::size_t k = 0; k < block_facets; ++k) {
      const double sum = value[k] + terms[k];
      const double part = sum - value[k];
      rest[k] += (value[k] - (sum - part)) + (terms[k] - part);
      value[k] = sum;
    }
  }
  [[nodiscard]] double total() const {
    CompensatedSum sum;
    for (const double lane : value) sum.add(lane);
    for (const double lane : rest) sum.add(lane);
    return sum.value();
  }
};

}  // namespace lrcs
