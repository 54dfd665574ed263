#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace lrcs {

// The order of points along a curve through space (Morton's): neighbours in space become neighbours in memory.
// shape: one index a point. laws: equal places on the curve keep their order.
template <int D>
[[nodiscard]] std::vector<std::uint32_t> curve_order(const std::vector<Eigen::Matrix<double, D, 1>>& points) {
  using Vector = Eigen::Matrix<double, D, 1>;
  constexpr int bits = 60 / D;
  if (points.empty()) return {};
  Vector low = points.front();
  Vector high = low;
  for (const Vector& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double width = std::max((high - low).maxCoeff(), 1e-300);
  const double cells = static_cast<double>((std::uint64_t{1} << static_cast<unsigned>(bits)) - 1);
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
  keys.reserve(points.size());
  for (const Vector& p : points) {
    std::uint64_t key = 0;
    for (int axis = 0; axis < D; ++axis) {
      const auto cell = static_cast<std::uint64_t>((p[axis] - low[axis]) / width * cells);
      for (int bit = 0; bit < bits; ++bit) key |= (cell >> bit & 1U) << (bit * D + axis);
    }
    keys.emplace_back(key, static_cast<std::uint32_t>(keys.size()));
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order;
  order.reserve(keys.size());
  for (const auto& key : keys) order.push_back(key.second);
  return order;
}

}  // namespace lrcs
