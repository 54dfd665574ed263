#include "lrcs/sweep_plan.h"

#include <algorithm>
#include <utility>

namespace lrcs {
namespace {

using Coordinates = std::array<double, 6>;

Coordinates coordinates_of(const Aspect& aspect) {
  Coordinates c{};
  for (std::size_t k = 0; k < 3; ++k) {
    // Zero has one sign.
    c[k] = aspect.to_transmitter[static_cast<Eigen::Index>(k)] + 0.0;
    c[k + 3] = aspect.to_receiver[static_cast<Eigen::Index>(k)] + 0.0;
  }
  return c;
}

// Of an aspect and its images the one whose coordinates come last.
Coordinates representative(const Aspect& aspect, const MirrorPlanes& planes) {
  Coordinates c = coordinates_of(aspect);
  for (std::size_t k = 0; k < 3; ++k) {
    if (!planes[k] || c[k] > 0.0 || (c[k] == 0.0 && c[k + 3] >= 0.0)) continue;
    c[k] = 0.0 - c[k];
    c[k + 3] = 0.0 - c[k + 3];
  }
  return c;
}

}  // namespace

std::vector<std::size_t> first_alike(const std::vector<Aspect>& aspects, const MirrorPlanes& planes) {
  std::vector<std::pair<Coordinates, std::size_t>> sorted;
  sorted.reserve(aspects.size());
  for (std::size_t k = 0; k < aspects.size(); ++k) sorted.emplace_back(representative(aspects[k], planes), k);
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::size_t> alike(aspects.size());
  std::size_t first = 0;
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    if (sorted[k].first != sorted[first].first) first = k;
    alike[sorted[k].second] = sorted[first].second;
  }
  return alike;
}

MirrorPlanes planes_of_use(const std::vector<Aspect>& aspects) {
  const auto different = [&](const MirrorPlanes& planes) {
    const auto alike = first_alike(aspects, planes);
    std::size_t rows = 0;
    for (std::size_t k = 0; k < alike.size(); ++k) rows += alike[k] == k ? 1 : 0;
    return rows;
  };
  constexpr MirrorPlanes all{true, true, true};
  const std::size_t fewest = different(all);
  MirrorPlanes of_use{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    MirrorPlanes others = all;
    others[axis] = false;
    of_use[axis] = different(others) > fewest;
  }
  return of_use;
}

}  // namespace lrcs
