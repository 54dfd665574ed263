#include "cli/scene_from_flags.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <sstream>

#include "base/digest.h"
#include "base/length.h"
#include "brdf/material_yaml.h"
#include "lrcs/sweep_yaml.h"

namespace lrcs {
namespace {

std::vector<std::string> split(const std::string& words, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(words);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  return parts;
}

double number_from(const std::string& word, const std::string& flag) {
  double value = 0.0;
  const char* end = word.data() + word.size();
  const char* begin = word.starts_with('+') ? word.data() + 1 : word.data();
  const auto [stop, wrong] = std::from_chars(begin, end, value);
  if (wrong != std::errc{} || stop != end || !std::isfinite(value))
    throw InputError(fmt::format("{}: expected a number, found '{}'", flag, word));
  return value;
}

double angle_from(const std::string& word, const std::string& flag, bool azimuth) {
  const double angle = number_from(word, flag);
  if (azimuth ? !is_azimuth(angle) : !is_elevation(angle))
    throw InputError(fmt::format("{}: expected {} deg, found {}", flag,
                                 azimuth ? "an azimuth of -360..360" : "an elevation of -90..90", word));
  return angle;
}

AspectAngles angle_pair(const std::string& words, const std::string& flag) {
  const auto parts = split(words, ',');
  if (parts.size() != 2)
    throw InputError(fmt::format("{}: expected AZIMUTH,ELEVATION in deg, found '{}'", flag, words));
  return {angle_from(parts[0], flag, true), angle_from(parts[1], flag, false)};
}

Receiver receiver_from(const SceneFlags& flags) {
  Receiver receiver;
  if (!flags.bistatic_angle.empty()) {
    if (flags.receiver != "monostatic") throw InputError("--bistatic-angle: expected it alone, found --receiver too");
    receiver.kind = Receiver::Kind::bistatic;
    receiver.bistatic_angle_deg = number_from(flags.bistatic_angle, "--bistatic-angle");
    if (std::abs(receiver.bistatic_angle_deg) > 180.0)
      throw InputError(fmt::format("--bistatic-angle: expected -180..180 deg, found {}", flags.bistatic_angle));
    receiver.plane = flags.plane == "elevation" ? Receiver::Plane::elevation : Receiver::Plane::azimuth;
  } else if (flags.receiver != "monostatic") {
    receiver.kind = Receiver::Kind::fixed;
    receiver.fixed = angle_pair(flags.receiver, "--receiver");
  }
  return receiver;
}

double wavelength_from(const std::string& words) {
  try {
    return words.empty() ? 0.0 : length_from_text(words);
  } catch (const std::invalid_argument& wrong) {
    throw InputError(fmt::format("--wavelength: {}", wrong.what()));
  }
}

FacetOutput facets_from(const std::string& words) {
  FacetOutput facets;
  if (words == "none") return facets;
  if (words == "all") {
    facets.all = true;
    return facets;
  }
  for (const auto& pair : split(words, ';')) {
    facets.directions.push_back(angle_pair(pair, "--facets"));
    facets.places.push_back(Place{"--facets"});
  }
  return facets;
}

}  // namespace

void SceneFlags::add_to(CLI::App& verb) {
  const std::string group = "Instead of a scene file";
  const auto axis = CLI::IsMember({"+x", "-x", "+y", "-y", "+z", "-z", "x", "y", "z"});
  verb.add_option("--unit", unit, "Unit of the target's coordinates (mm, m, inch, ...)")->group(group);
  verb.add_option("--material", material, "lambert:REFLECTANCE, a library name, or a material file")->group(group);
  verb.add_option("--azimuth", azimuth, "A, A,B,C or FROM:TO:STEP [deg]")->group(group);
  verb.add_option("--elevation", elevation, "The same (default 0)")->group(group);
  verb.add_option("--receiver", receiver, "monostatic (default), or AZIMUTH,ELEVATION of a fixed receiver")
      ->group(group);
  verb.add_option("--bistatic-angle", bistatic_angle, "True angle between transmitter and receiver [deg]")
      ->group(group);
  verb.add_option("--plane", plane, "Plane of the bistatic angle")
      ->check(CLI::IsMember({"azimuth", "elevation"}))
      ->group(group);
  verb.add_option("--wavelength", wavelength, "With its unit: \"1.06 um\"")->group(group);
  verb.add_option("--forward", forward, "File axis that is the nose (default +x)")->check(axis)->group(group);
  verb.add_option("--up", up, "File axis that is up (default +z)")->check(axis)->group(group);
  verb.add_option("--sides", sides, "Sides that reflect")->check(CLI::IsMember({"both", "front"}))->group(group);
  verb.add_option("--repair", repair, "auto (default) or none")->check(CLI::IsMember({"auto", "none"}))->group(group);
  verb.add_option("--facets", facets, "Facet files: none (default), all, or AZ,EL;AZ,EL...")->group(group);
}

bool SceneFlags::any() const {
  const SceneFlags none;
  return unit != none.unit || material != none.material || azimuth != none.azimuth || elevation != none.elevation ||
         receiver != none.receiver || wavelength != none.wavelength || bistatic_angle != none.bistatic_angle ||
         plane != none.plane || forward != none.forward || up != none.up || sides != none.sides ||
         repair != none.repair || facets != none.facets;
}

std::vector<double> angles_from_words(const std::string& words, const std::string& flag, bool azimuth) {
  std::vector<double> angles;
  const auto range = split(words, ':');
  if (range.size() == 3) {
    const double from = angle_from(range[0], flag, azimuth), to = angle_from(range[1], flag, azimuth);
    const double step = number_from(range[2], flag);
    if (step == 0.0) throw InputError(fmt::format("{}: expected a step other than 0 in '{}'", flag, words));
    if (std::abs(to - from) / std::abs(step) > static_cast<double>(most_directions))
      throw InputError(fmt::format("{}: the sweep has more than {} directions", flag, most_directions));
    angles = angle_range(from, to, step);
  } else if (range.size() <= 1) {
    for (const auto& word : split(words, ',')) angles.push_back(angle_from(word, flag, azimuth));
  } else {
    throw InputError(fmt::format("{}: expected A, A,B,C or FROM:TO:STEP, found '{}'", flag, words));
  }
  if (angles.empty()) throw InputError(fmt::format("{}: the sweep '{}' is empty", flag, words));
  return angles;
}

Scene scene_from_flags(const std::string& target, const SceneFlags& flags) {
  if (flags.unit.empty())
    throw InputError(fmt::format("--unit is missing: {} has no unit of its own; expected one of {}", target,
                                 fmt::join(length_units(), ", ")));
  if (flags.material.empty())
    throw InputError("--material is missing: expected lambert:REFLECTANCE, a library name or a file");
  if (flags.azimuth.empty()) throw InputError("--azimuth is missing: expected A, A,B,C or FROM:TO:STEP in deg");
  if (flags.forward.back() == flags.up.back())
    throw InputError(fmt::format("--up: expected another axis than --forward {}, found {}", flags.forward, flags.up));
  Scene scene;
  scene.name = "command line";
  scene.target = {
      target,   Place{"lrcs sweep"},    checked_unit(flags.unit, Place{"--unit"}),          flags.unit, flags.forward,
      flags.up, flags.repair == "auto", flags.sides == "front" ? Sides::front : Sides::both};
  scene.wavelength = wavelength_from(flags.wavelength);
  scene.materials = {material_from_words(flags.material)};
  scene.assign = {{AssignRule::By::everything, "", scene.materials.front().name, Place{"--material"}}};
  for (const double elevation : angles_from_words(flags.elevation, "--elevation", false))
    for (const double azimuth : angles_from_words(flags.azimuth, "--azimuth", true))
      scene.directions.push_back({azimuth, elevation});
  scene.receiver = receiver_from(flags);
  scene.facets = facets_from(flags.facets);
  const std::vector<std::string> said{flags.unit,     material_to_yaml(scene.materials.front()),
                                      flags.azimuth,  flags.elevation,
                                      flags.receiver, flags.wavelength,
                                      flags.plane,    flags.bistatic_angle,
                                      flags.forward,  flags.up,
                                      flags.sides,    flags.repair,
                                      flags.facets};
  scene.digest = digest_of(fmt::format("{}", fmt::join(said, "\n")));
  return scene;
}

}  // namespace lrcs
