#include "lrcs/sweep_yaml.h"

#include <fmt/format.h>

#include <cmath>

namespace lrcs {
namespace {

using Check = bool (*)(double);

double checked(const LocatedYaml& node, Check check, std::string_view domain) {
  const double angle = node.number();
  if (!check(angle)) node.fail(fmt::format("expected {}, found {}", domain, node.text()));
  return angle;
}

double azimuth_from(const LocatedYaml& node) {
  return checked(node, is_azimuth, "an azimuth of -360..360 deg");
}
double elevation_from(const LocatedYaml& node) {
  return checked(node, is_elevation, "an elevation of -90..90 deg");
}

std::vector<double> angles_from(const LocatedYaml& node, double (*angle_from)(const LocatedYaml&)) {
  std::vector<double> angles;
  if (node.is_sequence()) {
    for (const auto& item : node.items()) angles.push_back(angle_from(item));
    if (angles.empty()) node.fail("the sweep is empty: expected at least one angle");
    return angles;
  }
  if (!node.is_map()) return {angle_from(node)};
  node.allow_keys({"from", "to", "step"});
  const double from = angle_from(node.at("from"));
  const double to = angle_from(node.at("to"));
  const double step = node.at("step").number();
  if (step == 0.0) node.at("step").fail("expected a step other than 0 deg");
  if (std::abs(to - from) / std::abs(step) > static_cast<double>(most_directions))
    node.at("step").fail(fmt::format("the sweep has more than {} directions", most_directions));
  angles = angle_range(from, to, step);
  if (angles.empty())
    node.at("step").fail(fmt::format("the sweep is empty: from {} in steps of {} never comes to {}", from, step, to));
  return angles;
}

std::vector<AspectAngles> listed_directions(const LocatedYaml& list) {
  std::vector<AspectAngles> directions;
  for (const auto& item : list.items()) {
    if (!item.is_sequence()) item.fail("expected [azimuth, elevation] in deg, found " + found_in(item));
    const auto pair = item.items();
    if (pair.size() != 2)
      item.fail(fmt::format("expected [azimuth, elevation] in deg, found {} value{}", pair.size(),
                            pair.size() == 1 ? "" : "s"));
    directions.push_back({azimuth_from(pair[0]), elevation_from(pair[1])});
  }
  if (directions.empty()) list.fail("the sweep is empty: expected at least one [azimuth, elevation]");
  return directions;
}

}  // namespace

std::string found_in(const LocatedYaml& node) {
  if (node.is_map()) return "a mapping";
  if (node.is_sequence()) return "a list";
  return node.is_scalar() ? fmt::format("'{}'", node.text()) : "nothing";
}

bool is_azimuth(double angle_deg) {
  return angle_deg >= -360.0 && angle_deg <= 360.0;
}
bool is_elevation(double angle_deg) {
  return angle_deg >= -90.0 && angle_deg <= 90.0;
}

std::vector<double> angle_range(double from_deg, double to_deg, double step_deg) {
  // A last step that rounding keeps from `to` by a millionth of a step still counts.
  constexpr double slack = 1.0 / 1048576.0;
  const double steps = std::floor((to_deg - from_deg) / step_deg + slack);
  const bool reaches_end = std::abs(from_deg + steps * step_deg - to_deg) <= slack * std::abs(step_deg);
  std::vector<double> angles;
  // Where the steps divide the range, a share of the range is the double nearest to the decimals: 0.3, not 3 * 0.1.
  for (double k = 0.0; k <= steps; k += 1.0)
    angles.push_back(reaches_end && steps > 0.0 ? from_deg + (to_deg - from_deg) * k / steps : from_deg + k * step_deg);
  return angles;
}

std::vector<AspectAngles> sweep_from_yaml(const LocatedYaml& sweep) {
  sweep.allow_keys({"azimuth", "elevation", "directions"});
  if (sweep.has("directions")) {
    for (const auto* key : {"azimuth", "elevation"})
      if (sweep.has(key)) sweep.key_place(key).fail(fmt::format("expected either directions or {}, found both", key));
    return listed_directions(sweep.at("directions"));
  }
  if (!sweep.has("azimuth")) sweep.fail("key 'azimuth' or 'directions' is missing");
  const auto azimuths = angles_from(sweep.at("azimuth"), azimuth_from);
  const auto elevations =
      sweep.has("elevation") ? angles_from(sweep.at("elevation"), elevation_from) : std::vector{0.0};
  if (azimuths.size() * elevations.size() > most_directions)
    sweep.fail(fmt::format("the sweep has more than {} directions", most_directions));
  std::vector<AspectAngles> directions;
  directions.reserve(azimuths.size() * elevations.size());
  for (const double elevation : elevations)
    for (const double azimuth : azimuths) directions.push_back({azimuth, elevation});
  return directions;
}

AspectAngles angles_from_yaml(const LocatedYaml& node) {
  node.allow_keys({"azimuth", "elevation"});
  return {azimuth_from(node.at("azimuth")), elevation_from(node.at("elevation"))};
}

Receiver receiver_from_yaml(const LocatedYaml& node) {
  Receiver receiver;
  if (!node.is_map()) {
    if (!node.is_scalar() || node.text() != "monostatic")
      node.fail(fmt::format(
          "expected monostatic, {{azimuth: A, elevation: E}} or {{bistatic_angle: B, plane: azimuth}}, found {}",
          found_in(node)));
    return receiver;
  }
  node.allow_keys({"azimuth", "elevation", "bistatic_angle", "plane"});
  if (!node.has("bistatic_angle")) {
    if (node.has("plane")) node.key_place("plane").fail("plane belongs to bistatic_angle, which is missing");
    receiver.kind = Receiver::Kind::fixed;
    receiver.fixed = angles_from_yaml(node);
    return receiver;
  }
  for (const auto* key : {"azimuth", "elevation"})
    if (node.has(key)) node.key_place(key).fail(fmt::format("expected either bistatic_angle or {}, found both", key));
  receiver.kind = Receiver::Kind::bistatic;
  receiver.bistatic_angle_deg = checked(
      node.at("bistatic_angle"), [](double b) { return b >= -180.0 && b <= 180.0; }, "an angle of -180..180 deg");
  if (node.has("plane") && node.at("plane").one_of({"azimuth", "elevation"}) == "elevation")
    receiver.plane = Receiver::Plane::elevation;
  return receiver;
}

}  // namespace lrcs
