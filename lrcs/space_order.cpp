#include "lrcs/space_order.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace lrcs {
namespace {

// Halving by number keeps the depth of the recursion at log2 of the number of points, wherever they lie.
void part(const std::vector<Vec3>& points, std::vector<std::uint32_t>& order, std::uint32_t first, std::uint32_t last) {
  if (last - first <= space_leaf) return;
  Vec3 low = points[order[first]];
  Vec3 high = low;
  for (std::uint32_t k = first; k < last; ++k) {
    low = low.cwiseMin(points[order[k]]);
    high = high.cwiseMax(points[order[k]]);
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const std::uint32_t middle = middle_of(first, last);
  std::nth_element(
      order.begin() + first, order.begin() + middle, order.begin() + last,
      [&](std::uint32_t a, std::uint32_t b) { return std::pair(points[a][axis], a) < std::pair(points[b][axis], b); });
  part(points, order, first, middle);
  part(points, order, middle, last);
}

}  // namespace

std::vector<std::uint32_t> space_order(const std::vector<Vec3>& points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  part(points, order, 0, static_cast<std::uint32_t>(points.size()));
  return order;
}

}  // namespace lrcs
