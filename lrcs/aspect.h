#pragma once
#include <vector>

#include "base/direction.h"

namespace lrcs {

// One row of a sweep: where the transmitter and the receiver stand, seen from the target.
struct Aspect {
  AspectAngles transmitter, receiver;  // [deg]
  Vec3 to_transmitter, to_receiver;    // unit, body frame
};

// The aspect of two directions given by their angles.
[[nodiscard]] inline Aspect aspect_between(const AspectAngles& transmitter, const AspectAngles& receiver) {
  return {transmitter, receiver, direction_of(transmitter), direction_of(receiver)};
}

// Where the receiver stands while the transmitter sweeps.
struct Receiver {
  enum class Kind { monostatic, fixed, bistatic };
  enum class Plane { azimuth, elevation };
  Kind kind = Kind::monostatic;
  AspectAngles fixed;               // kind fixed: its direction in the body frame
  double bistatic_angle_deg = 0.0;  // kind bistatic: the true angle between the two directions, -180..180
  Plane plane = Plane::azimuth;     //   toward growing azimuth, or growing elevation, of the transmitter
};

// The aspect for a transmitter direction.
// value: bistatic: d_r = d_i cos B + e sin B, e the unit vector along which azimuth (elevation) grows at d_i.
// laws: monostatic, and B = 0: to_receiver == to_transmitter, to the last bit.
[[nodiscard]] inline Aspect aspect_of(const AspectAngles& transmitter, const Receiver& receiver) {
  const Vec3 di = direction_of(transmitter);
  if (receiver.kind == Receiver::Kind::fixed) return aspect_between(transmitter, receiver.fixed);
  if (receiver.kind == Receiver::Kind::monostatic || receiver.bistatic_angle_deg == 0.0)
    return {transmitter, transmitter, di, di};
  const auto [cos_b, sin_b] = cos_sin_deg(receiver.bistatic_angle_deg);
  const bool azimuth = receiver.plane == Receiver::Plane::azimuth;
  const Vec3 e = azimuth ? along_azimuth(transmitter) : along_elevation(transmitter);
  const Vec3 dr = (di * cos_b + e * sin_b).normalized();
  return {transmitter, angles_of(dr), di, dr};
}

// One for each direction of the transmitter, in their order.
[[nodiscard]] inline std::vector<Aspect> aspects_of(const std::vector<AspectAngles>& transmitters,
                                                    const Receiver& receiver) {
  std::vector<Aspect> aspects;
  aspects.reserve(transmitters.size());
  for (const AspectAngles& transmitter : transmitters) aspects.push_back(aspect_of(transmitter, receiver));
  return aspects;
}

}  // namespace lrcs
