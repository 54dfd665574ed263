#include "lrcs/facet_sight.h"

#include <algorithm>
#include <cmath>

#include "lrcs/unit_triangle.h"

namespace lrcs {

void FacetSight::look_at(const ViewOutline& view, const std::array<std::uint32_t, 3>& ids) {
  ids_ = ids;
  x0_ = view.x()[ids[0]];
  y0_ = view.y()[ids[0]];
  z0_ = view.z()[ids[0]];
  const double ax = view.x()[ids[1]] - x0_, ay = view.y()[ids[1]] - y0_;
  const double bx = view.x()[ids[2]] - x0_, by = view.y()[ids[2]] - y0_;
  const double area = ax * by - ay * bx;
  u_x_ = by / area;
  u_y_ = -bx / area;
  v_x_ = -ay / area;
  v_y_ = ax / area;
  z_u_ = view.z()[ids[1]] - z0_;
  z_v_ = view.z()[ids[2]] - z0_;
  // An error of the view's rounding in each coordinate of the place and of the corners, to first order twice that.
  const double sides = std::abs(ax) + std::abs(ay) + std::abs(bx) + std::abs(by);
  slack_ = 8.0 * view.rounding() * sides / std::abs(area);
  height_slack_ = 4.0 * view.rounding() + 2.0 * slack_ * (std::abs(z_u_) + std::abs(z_v_));
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
      p.u = u_x_ * dx + u_y_ * dy;
      p.v = v_x_ * dx + v_y_ * dy;
      const double reach = 1.0 + std::abs(p.u) + std::abs(p.v);
      most = std::max(most, reach);
      behind = behind && at.z() - (z0_ + p.u * z_u_ + p.v * z_v_) < -height_slack_ * reach;
    }
    beyond &= sides_beyond(p, corner[k], slack_ * (1.0 + std::abs(p.u) + std::abs(p.v)));
  }
  return beyond != 0 || behind || line_passes_by(end[0], corner[0], end[1], corner[1], slack_ * most);
}

}  // namespace lrcs
