#include "lrcs/sweep_plan.h"

#include <algorithm>
#include <map>

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
  std::map<Coordinates, std::size_t> first;
  std::vector<std::size_t> alike;
  alike.reserve(aspects.size());
  for (std::size_t k = 0; k < aspects.size(); ++k)
    alike.push_back(first.try_emplace(representative(aspects[k], planes), k).first->second);
  return alike;
}

}  // namespace lrcs
