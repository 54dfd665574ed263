#include "lrcs/space_order.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <span>

#include "base/large_pages.h"

namespace lrcs {
namespace {

// A point on a grid of 2^32 steps along the longest side of a box around it and others.
struct NumberedPoint {
  std::array<std::uint32_t, 3> at;
  std::uint32_t number;

  // Different for each point.
  [[nodiscard]] std::uint64_t key(std::size_t axis) const { return std::uint64_t{at[axis]} << 32U | number; }
};

// Lays the grid around these places alone.
void lay_grid(std::span<NumberedPoint> places, const std::vector<Vec3>& points) {
  Vec3 low = points[places.front().number];
  Vec3 high = low;
  for (const NumberedPoint& p : places) {
    low = low.cwiseMin(points[p.number]);
    high = high.cwiseMax(points[p.number]);
  }
  const double longest = (high - low).maxCoeff();
  // So small a spread has no steps that are doubles: all points count as one.
  constexpr double least_spread = 0x1p-900;
  const double steps = longest > least_spread ? 4294967295.0 / longest : 0.0;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, places.size(), 4096), [&](const auto& range) {
    for (std::size_t k = range.begin(); k < range.end(); ++k)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<Eigen::Index>(axis);
        places[k].at[axis] =
            static_cast<std::uint32_t>(std::min((points[places[k].number][i] - low[i]) * steps, 4294967295.0));
      }
  });
}

std::array<std::uint32_t, 3> sides_of(std::span<const NumberedPoint> places) {
  std::array<std::uint32_t, 3> low = places.front().at, high = low;
  for (const NumberedPoint& p : places)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], p.at[axis]);
      high[axis] = std::max(high[axis], p.at[axis]);
    }
  std::array<std::uint32_t, 3> sides{};
  for (std::size_t axis = 0; axis < 3; ++axis) sides[axis] = high[axis] - low[axis];
  return sides;
}

// Where fewer steps than these lie along places, the grid is too coarse for them: a point far from all others makes it
// so.
constexpr std::uint32_t least_steps = 1U << 12U;

// Lays a finer grid first where this one is too coarse.
std::size_t longest_axis(std::span<NumberedPoint> places, const std::vector<Vec3>& points) {
  auto sides = sides_of(places);
  if (*std::max_element(sides.begin(), sides.end()) < least_steps) {
    lay_grid(places, points);
    sides = sides_of(places);
  }
  return static_cast<std::size_t>(std::max_element(sides.begin(), sides.end()) - sides.begin());
}

// A key that about so many of the places are below.
std::uint64_t key_near(std::span<const NumberedPoint> places, std::size_t rank, std::size_t axis) {
  constexpr std::size_t most = 63, few = 15, many_places = 2048;
  std::array<std::uint64_t, most> sample{};
  const std::size_t size = places.size() < many_places ? few : most;
  for (std::size_t k = 0; k < size; ++k) sample[k] = places[k * places.size() / size].key(axis);
  const auto wanted = sample.begin() + static_cast<std::ptrdiff_t>(rank * size / places.size());
  std::nth_element(sample.begin(), wanted, sample.begin() + size);
  return *wanted;
}

// std::nth_element() by the key, without a branch for each place: what is below the middle goes before it.
void halve(std::span<NumberedPoint> places, std::size_t middle, std::size_t axis) {
  constexpr int most_rounds = 32;  // whatever the samples are
  constexpr std::size_t few = 64;
  std::size_t first = 0, last = places.size();
  for (int round = 0; round < most_rounds && last - first > few; ++round) {
    const std::uint64_t pivot = key_near(places.subspan(first, last - first), middle - first, axis);
    std::size_t end = first;  // of those below the pivot
    for (std::size_t k = first; k < last; ++k) {
      const NumberedPoint here = places[k];
      places[k] = places[end];
      places[end] = here;
      end += here.key(axis) < pivot ? 1 : 0;
    }
    (middle < end ? last : first) = end;
  }
  const auto at = [&](std::size_t k) { return places.begin() + static_cast<std::ptrdiff_t>(k); };
  std::nth_element(at(first), at(middle), at(last),
                   [axis](const NumberedPoint& a, const NumberedPoint& b) { return a.key(axis) < b.key(axis); });
}

std::uint32_t steps_along(std::span<const NumberedPoint> places, std::size_t axis) {
  const auto [low, high] =
      std::ranges::minmax_element(places, {}, [axis](const NumberedPoint& p) { return p.at[axis]; });
  return high->at[axis] - low->at[axis];
}

// By the points themselves.
void halve_exactly(std::span<NumberedPoint> places, std::size_t middle, std::size_t axis,
                   const std::vector<Vec3>& points) {
  const auto i = static_cast<Eigen::Index>(axis);
  std::nth_element(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(middle), places.end(),
                   [&](const NumberedPoint& a, const NumberedPoint& b) {
                     const double x = points[a.number][i], y = points[b.number][i];
                     return x != y ? x < y : a.number < b.number;
                   });
}

// Halving by number keeps the depth of the recursion at log2 of the number of points, wherever they lie.
void part(std::span<NumberedPoint> places, const std::vector<Vec3>& points) {
  if (places.size() <= space_leaf) return;
  const std::size_t axis = longest_axis(places, points);
  const std::uint32_t middle = middle_of(0, static_cast<std::uint32_t>(places.size()));
  halve(places, middle, axis);
  const auto parts = std::array{places.first(middle), places.subspan(middle)};
  if (std::min(steps_along(parts[0], axis), steps_along(parts[1], axis)) < least_steps)
    halve_exactly(places, middle, axis, points);
  constexpr std::size_t worth_a_thread = 4096;
  if (places.size() >= worth_a_thread)
    tbb::parallel_invoke([&] { part(parts[0], points); }, [&] { part(parts[1], points); });
  else
    for (const auto& half : parts) part(half, points);
}

}  // namespace

std::vector<std::uint32_t> space_order(const std::vector<Vec3>& points) {
  std::vector<NumberedPoint> places = large_vector<NumberedPoint>(points.size());
  for (std::uint32_t k = 0; k < places.size(); ++k) places[k].number = k;
  if (!places.empty()) lay_grid(places, points);
  part(places, points);
  std::vector<std::uint32_t> order;
  reserve_large(order, places.size());
  for (const NumberedPoint& p : places) order.push_back(p.number);
  return order;
}

}  // namespace lrcs
