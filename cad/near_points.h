#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "base/vec3.h"

namespace lrcs {

// Points of which those nearer than a tolerance are one: faces of a CAD file meet within its tolerance, not exactly.
// The first point of a neighbourhood stands for all.
class NearPoints {
 public:
  // domain: tolerance above 0 and above the rounding of the points.
  explicit NearPoints(double tolerance) : tolerance_(tolerance) {}

  // The number given to an earlier point near to this one, or nothing; remembers `number` for it then.
  [[nodiscard]] std::uint32_t find_or_add(const Vec3& p, std::uint32_t number) {
    const Cell corner = cell_of(p - Vec3::Constant(tolerance_));
    for (int k = 0; k < 8; ++k) {
      const Cell cell{corner[0] + (k & 1), corner[1] + (k >> 1 & 1), corner[2] + (k >> 2)};
      if (const auto found = cells_.find(cell); found != cells_.end())
        for (const Known& known : found->second)
          if ((known.point - p).squaredNorm() <= tolerance_ * tolerance_) return known.number;
    }
    cells_[cell_of(p)].push_back({p, number});
    return number;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  struct Known {
    Vec3 point;
    std::uint32_t number;
  };
  struct Hash {
    std::size_t operator()(const Cell& cell) const {
      std::uint64_t hash = 0;
      for (const std::int64_t x : cell) hash = (hash ^ static_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15U;
      return hash ^ hash >> 32U;
    }
  };
  // Cells of twice the tolerance: a ball of that radius meets two in each direction at most.
  [[nodiscard]] Cell cell_of(const Vec3& p) const {
    const auto index = [&](double x) { return static_cast<std::int64_t>(std::floor(x / (2.0 * tolerance_))); };
    return {index(p.x()), index(p.y()), index(p.z())};
  }

  double tolerance_;
  std::unordered_map<Cell, std::vector<Known>, Hash> cells_;
};

}  // namespace lrcs
