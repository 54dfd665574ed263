#pragma once
#include <string>
#include <vector>

#include "base/located_yaml.h"
#include "lrcs/aspect.h"
#include "lrcs/scene.h"

namespace lrcs {

// The parts of a scene file that hold angles [deg]. All throw InputError at the value's place.

inline constexpr std::size_t most_directions = 10'000'000;

// {azimuth: A, elevation: E}, each a number, a list or {from, to, step}: every pair, azimuth running fastest.
// Or {directions: [[azimuth, elevation], ...]}.
[[nodiscard]] std::vector<AspectAngles> sweep_from_yaml(const LocatedYaml& sweep);

// {azimuth: A, elevation: E}.
[[nodiscard]] AspectAngles angles_from_yaml(const LocatedYaml& node);

// monostatic, {azimuth: A, elevation: E}, or {bistatic_angle: B, plane: azimuth | elevation}.
[[nodiscard]] Receiver receiver_from_yaml(const LocatedYaml& node);

// The angles from, from + step, ... as far as `to`. Empty where the step leads away from `to`.
// domain: step not 0.
[[nodiscard]] std::vector<double> angle_range(double from_deg, double to_deg, double step_deg);

// What stands there instead of what was expected, for messages: 'word', a list, a mapping, nothing.
[[nodiscard]] std::string found_in(const LocatedYaml& node);

// Is the azimuth within -360..360 and the elevation within -90..90?
[[nodiscard]] bool is_azimuth(double angle_deg);
[[nodiscard]] bool is_elevation(double angle_deg);

}  // namespace lrcs
