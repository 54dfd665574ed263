#pragma once
#include <array>
#include <cmath>

#include "lrcs/facet_frame.h"

namespace lrcs {

// Where places lie to a facet in its own coordinates (u, v): the triangle (0, 0), (1, 0), (0, 1). Side k runs from
// corner k to corner k + 1: v = 0, u + v = 1, u = 0.

// The sides (bit k: side k) beyond which a place certainly lies, or on which it lies as the facet's own corner.
// `corner`: which of the facet's corners the place is, -1: none. `slack`: error of u and v.
[[nodiscard]] inline unsigned sides_beyond(const FacetPoint& p, int corner, double slack) {
  constexpr std::array<unsigned, 3> of_corner{0b101, 0b011, 0b110};
  if (corner >= 0) return of_corner[static_cast<std::size_t>(corner)];
  return (p.v < -slack ? 1U : 0U) | (p.u + p.v > 1.0 + 2.0 * slack ? 2U : 0U) | (p.u < -slack ? 4U : 0U);
}

// Twice the area of the triangle of two places and a third one: positive left of the line from a to b.
[[nodiscard]] inline double side_of_line(const FacetPoint& a, const FacetPoint& b, double u, double v) {
  return (b.u - a.u) * (v - a.v) - (b.v - a.v) * (u - a.u);
}

enum class Beside { left, right, either };

// Does the line through two places certainly have the triangle on one side of it, but for a corner that is one of the
// two?
[[nodiscard]] inline bool line_passes_by(const FacetPoint& a, int corner_a, const FacetPoint& b, int corner_b,
                                         double slack, Beside where = Beside::either) {
  const double threshold = 4.0 * slack * (std::abs(b.u - a.u) + std::abs(b.v - a.v) + 1.0);
  const double at0 = side_of_line(a, b, 0.0, 0.0);
  const std::array<double, 3> side{at0, at0 - (b.v - a.v), at0 + (b.u - a.u)};  // of the corners
  bool left = where != Beside::right, right = where != Beside::left;
  for (int k = 0; k < 3; ++k) {
    if (k == corner_a || k == corner_b) continue;
    left = left && side[static_cast<std::size_t>(k)] > threshold;
    right = right && side[static_cast<std::size_t>(k)] < -threshold;
  }
  return left || right;
}

// Squared distance of a place from a segment.
[[nodiscard]] inline double squared_distance(double u, double v, const FacetPoint& a, const FacetPoint& b) {
  const double du = b.u - a.u, dv = b.v - a.v;
  const double pu = u - a.u, pv = v - a.v;
  const double length = du * du + dv * dv;
  const double t = length > 0.0 ? std::fmin(1.0, std::fmax(0.0, (pu * du + pv * dv) / length)) : 0.0;
  const double eu = pu - t * du, ev = pv - t * dv;
  return eu * eu + ev * ev;
}

}  // namespace lrcs
