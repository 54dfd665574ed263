#pragma once
#include <cmath>

#include "base/vec3.h"

namespace lrcs {

// An aspect direction in the body frame [deg]: azimuth from +x toward +y, elevation from the xy-plane toward +z.
// (0, 0) is nose-on.
struct AspectAngles {
  double azimuth_deg = 0.0;
  double elevation_deg = 0.0;
  bool operator==(const AspectAngles&) const = default;
};

// cos and sin of an angle in degrees; exact at the multiples of 90.
struct CosSin {
  double cos, sin;
};
[[nodiscard]] inline CosSin cos_sin_deg(double angle_deg) {
  const double turns = std::nearbyint(angle_deg / 90.0);
  const double rest = std::remainder(angle_deg, 90.0) * degree;
  const double c = std::cos(rest);
  const double s = std::sin(rest);
  switch (static_cast<int>(turns - 4.0 * std::floor(turns / 4.0))) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

// The unit vector (cos el cos az, cos el sin az, sin el), from the target outward.
[[nodiscard]] inline Vec3 direction_of(const AspectAngles& angles) {
  const auto [cos_az, sin_az] = cos_sin_deg(angles.azimuth_deg);
  const auto [cos_el, sin_el] = cos_sin_deg(angles.elevation_deg);
  return {cos_el * cos_az, cos_el * sin_az, sin_el};
}

// The unit vector along which azimuth (elevation) grows at a direction.
[[nodiscard]] inline Vec3 along_azimuth(const AspectAngles& angles) {
  const auto [cos_az, sin_az] = cos_sin_deg(angles.azimuth_deg);
  return {-sin_az, cos_az, 0.0};
}
[[nodiscard]] inline Vec3 along_elevation(const AspectAngles& angles) {
  const auto [cos_az, sin_az] = cos_sin_deg(angles.azimuth_deg);
  const auto [cos_el, sin_el] = cos_sin_deg(angles.elevation_deg);
  return {-sin_el * cos_az, -sin_el * sin_az, cos_el};
}

// The inverse of direction_of: azimuth in [0, 360), elevation in [-90, 90]. Straight up or down the azimuth is 0.
[[nodiscard]] inline AspectAngles angles_of(const Vec3& direction) {
  const double across = std::hypot(direction.x(), direction.y());
  double azimuth = across == 0.0 ? 0.0 : std::atan2(direction.y(), direction.x()) / degree;
  if (azimuth < 0.0) azimuth += 360.0;
  return {azimuth == 360.0 ? 0.0 : azimuth, std::atan2(direction.z(), across) / degree};
}

}  // namespace lrcs
