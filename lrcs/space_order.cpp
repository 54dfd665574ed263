#include "lrcs/space_order.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace lrcs {
namespace {

struct Numbered {
  Vec3 point;
  std::uint32_t number;
};

// Halving by number keeps the depth of the recursion at log2 of the number of points, wherever they lie.
void part(std::span<Numbered> points) {
  if (points.size() <= space_leaf) return;
  Vec3 low = points.front().point;
  Vec3 high = low;
  for (const Numbered& p : points) {
    low = low.cwiseMin(p.point);
    high = high.cwiseMax(p.point);
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const std::uint32_t middle = middle_of(0, static_cast<std::uint32_t>(points.size()));
  std::nth_element(points.begin(), points.begin() + middle, points.end(), [&](const Numbered& a, const Numbered& b) {
    return std::pair(a.point[axis], a.number) < std::pair(b.point[axis], b.number);
  });
  const auto parts = std::array{points.first(middle), points.subspan(middle)};
  constexpr std::size_t worth_a_thread = 4096;
  if (points.size() >= worth_a_thread)
    tbb::parallel_invoke([&] { part(parts[0]); }, [&] { part(parts[1]); });
  else
    for (const auto& half : parts) part(half);
}

}  // namespace

std::vector<std::uint32_t> space_order(const std::vector<Vec3>& points) {
  std::vector<Numbered> numbered;
  numbered.reserve(points.size());
  for (const Vec3& point : points) numbered.push_back({point, static_cast<std::uint32_t>(numbered.size())});
  part(numbered);
  std::vector<std::uint32_t> order;
  order.reserve(points.size());
  for (const Numbered& p : numbered) order.push_back(p.number);
  return order;
}

}  // namespace lrcs
