#include "lrcs/facet_sight.h"

#include <algorithm>
#include <cmath>

#include "lrcs/unit_triangle.h"

namespace lrcs {

void FacetSight::look_at(const SeenFacet& facet, const std::array<std::uint32_t, 3>& ids, double rounding) {
  ids_ = ids;
  x0_ = facet.x[0];
  y0_ = facet.y[0];
  z0_ = facet.z[0];
  own_ = facet.own_coordinates();
  z_u_ = facet.z[1] - z0_;
  z_v_ = facet.z[2] - z0_;
  // An error of the view's rounding in each coordinate of the place and of the corners, to first order twice that.
  slack_ = 8.0 * rounding * facet.sides() / std::abs(facet.area());
  height_slack_ = 4.0 * rounding + 2.0 * slack_ * (std::abs(z_u_) + std::abs(z_v_));
}

bool FacetSight::certainly_passes_by(const OutlineEdge& edge) const {
  // Also where the area is zero or not a number.
  constexpr double too_thin = 0x1p-20;
  if (!(slack_ < too_thin)) return false;
  constexpr std::array<FacetPoint, 3> corners{{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}};
  std::array<FacetPoint, 2> end{};
  std::array<int, 2> corner{-1, -1};
  unsigned beyond = 7;
  double most = 0.0;
  bool behind = true;
  for (std::size_t k = 0; k < 2; ++k) {
    const std::uint32_t id = k == 0 ? edge.low : edge.high;
    for (int c = 0; c < 3; ++c)
      if (ids_[static_cast<std::size_t>(c)] == id) corner[k] = c;
    FacetPoint& p = end[k];
    if (corner[k] >= 0) {
      p = corners[static_cast<std::size_t>(corner[k])];
    } else {
      const Vec3& at = k == 0 ? edge.at_low : edge.at_high;
      const double dx = at.x() - x0_, dy = at.y() - y0_;
      p.u = own_.u_x * dx + own_.u_y * dy;
      p.v = own_.v_x * dx + own_.v_y * dy;
      const double reach = 1.0 + std::abs(p.u) + std::abs(p.v);
      most = std::max(most, reach);
      behind = behind && at.z() - (z0_ + p.u * z_u_ + p.v * z_v_) < -height_slack_ * reach;
    }
    beyond &= sides_beyond(p, corner[k], slack_ * (1.0 + std::abs(p.u) + std::abs(p.v)));
  }
  return beyond != 0 || behind || line_passes_by(end[0], corner[0], end[1], corner[1], slack_ * most);
}

}  // namespace lrcs
