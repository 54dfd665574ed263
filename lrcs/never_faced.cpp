#include "lrcs/never_faced.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "lrcs/facet_frame.h"

namespace lrcs {
namespace {

bool is_turned_away(const Vec3& cross, const Vec3& toward) {
  // As FacetFrame::edge_on().
  return cross.dot(toward) < -8.0 * unit_roundoff * cross.lpNorm<1>();
}

}  // namespace

std::vector<std::uint8_t> facets_ever_faced(const Surface& surface, std::span<const Vec3> viewers) {
  const auto facets = static_cast<std::uint32_t>(surface.occluders.size());
  std::vector<std::uint8_t> faced(facets, 1);
  tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, facets), [&](const auto& range) {
    std::size_t last = 0;  // who faces one facet often faces the next one too
    for (std::uint32_t f = range.begin(); f < range.end(); ++f) {
      if (surface.of_solid[f] == 0) continue;
      const Vec3& cross = surface.occluders.cross[f];
      std::size_t asked = 0;
      while (asked < viewers.size() && is_turned_away(cross, viewers[(last + asked) % viewers.size()])) ++asked;
      faced[f] = asked < viewers.size() ? 1 : 0;
      if (faced[f] != 0) last = (last + asked) % viewers.size();
    }
  });
  return faced;
}

}  // namespace lrcs
