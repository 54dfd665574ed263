#pragma once
#include <algorithm>
#include <cmath>

#include "base/vec3.h"

namespace lrcs {

// Where a pair of directions lies among all pairs, as an isotropic, reciprocal surface that is its own mirror image
// tells them apart: a point in space. Measured values are interpolated there (brdf/tabulated.h).
// value: with theta_h the angle of the half vector from the normal, theta_d half the angle between the directions,
//   phi_d the azimuth of their difference about the half vector, and R^2 = theta_h^2 + theta_d^2 [rad]:
//     x = (theta_h^2 - theta_d^2) / R,   (y, z) = stretch (2 theta_h theta_d / R) (|cos phi_d|, |sin phi_d|).
//   Specular pairs (theta_h = 0) are the axis x <= 0, x = -theta_d; retro pairs (theta_d = 0) the axis x >= 0,
//   x = theta_h; pairs in the plane of incidence have z = 0.
// why: phi_d means nothing at theta_h = 0 and at theta_d = 0. Of two vectors in a plane, of lengths theta_h and
// theta_d,
//   what turning both together leaves is a point of Hopf's map, which is this one: continuous and one to one, at most
//   2 stretch times as steep in one direction as in another. Near either axis (y, z) is 2 stretch times the offset
//   from the lobe's peak, x the place along it: a lobe that keeps its shape lies along x.
// laws: exchanging the directions gives the same to the last bit; so does a mirror (these two fold y and z to >= 0).
// source: for theta_h, theta_d, phi_d: S. Rusinkiewicz, A new change of variables for efficient BRDF representation,
//   1998.
// check: tests/brdf/pair_place_test.cpp.

// Neighbours along a lobe count as nearer than those across it: measured incidences are farther apart than the
// directions of one scan. Half way between incidences that are D apart a triangulation joins places as far from the
// peak as theta_h = D / (2 (1 + 4 stretch^2)), D / 34: a lobe narrower than that is blurred. A larger stretch blurs
// less, and makes simplices longer than a smooth f_r likes: at 4 and 8 the test of convergence at second order fails.
inline constexpr double pair_stretch = 2.0;

[[nodiscard]] inline Vec3 pair_place(double theta_h, double theta_d, double cos_phi_d, double sin_phi_d) {
  const double radius = std::hypot(theta_h, theta_d);
  if (radius == 0.0) return Vec3::Zero();
  const double across = pair_stretch * 2.0 * theta_h * (theta_d / radius);
  return {(theta_h - theta_d) * ((theta_h + theta_d) / radius), across * std::abs(cos_phi_d),
          across * std::abs(sin_phi_d)};
}

// domain: unit vectors, wi and wr above the surface.
[[nodiscard]] inline Vec3 pair_place(const Vec3& wi, const Vec3& wr, const Vec3& n) {
  const Vec3 sum = wi + wr;
  const Vec3 difference = wi - wr;
  const double length = sum.stableNorm();
  if (length == 0.0) return pair_place(0.5 * std::numbers::pi, 0.5 * std::numbers::pi, 1.0, 0.0);
  const Vec3 h = sum / length;
  const double h_n = h.dot(n);
  const double theta_h = std::atan2((h - h_n * n).norm(), h_n);
  const double theta_d = std::atan2(difference.norm(), length);
  // The normal as seen from the half vector: along the difference, and across.
  const double along = std::abs(n.dot(difference) - h_n * h.dot(difference));
  const double across = std::abs(n.dot(h.cross(difference)));
  const double both = std::hypot(along, across);
  return both > 0.0 ? pair_place(theta_h, theta_d, along / both, across / both)
                    : pair_place(theta_h, theta_d, 1.0, 0.0);
}

// The same at wi = wr.
[[nodiscard]] inline Vec3 pair_place_retro(double cosine) {
  const double c = std::min(cosine, 1.0);
  return {std::atan2(std::sqrt((1.0 - c) * (1.0 + c)), c), 0.0, 0.0};
}

}  // namespace lrcs
