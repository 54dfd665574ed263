#pragma once
#include <cmath>
#include <optional>

#include "base/vec3.h"
#include "lrcs/facet_frame.h"
#include "mesh/exact_height.h"

namespace lrcs {

// Which side of a facet's plane a point is on: +1 in front of it, -1 behind it, 0 in it; nothing where rounding could
// change the answer. a: any corner; cross: facet_cross() of the corners.
[[nodiscard]] inline std::optional<int> certain_plane_side(const Vec3& a, const Vec3& cross, const Vec3& p) {
  const Vec3 terms = (p - a).cwiseProduct(cross);
  const double height = terms.sum();
  // As FacetFrame::at_vertex().
  if (std::abs(height) > 8.0 * unit_roundoff * terms.lpNorm<1>()) return height > 0.0 ? 1 : -1;
  if (terms.isZero(0.0)) return 0;
  return std::nullopt;
}

// The same, exactly. cost: that of exact_height() where rounding could change the answer.
[[nodiscard]] inline int plane_side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& cross, const Vec3& p) {
  if (const auto side = certain_plane_side(a, cross, p)) return *side;
  const double height = exact_height(a, b, c, p);
  return (height > 0.0 ? 1 : 0) - (height < 0.0 ? 1 : 0);
}

}  // namespace lrcs
