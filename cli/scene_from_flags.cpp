#include "cli/scene_from_flags.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/digest.h"
#include "base/length.h"
#include "base/nearest_name.h"
#include "brdf/material_yaml.h"
#include "cli/flag_words.h"
#include "lrcs/sweep_yaml.h"
#include "mesh/file_format.h"

namespace lrcs {
namespace {

// One of the words; the nearest is named where it is none.
CLI::Validator one_of(const std::vector<std::string>& words) {
  const auto complaint = [words](const std::string& word) -> std::string {
    if (std::find(words.begin(), words.end(), word) != words.end()) return "";
    return fmt::format("expected {}, found '{}'{}", fmt::join(words, " or "), word, did_you_mean(word, words));
  };
  return {complaint, fmt::format("{}", fmt::join(words, "|"))};
}

Receiver receiver_from(const SceneFlags& flags) {
  Receiver receiver;
  if (flags.given("--bistatic-angle")) {
    if (flags.given("--receiver"))
      throw InputError("--receiver: expected either --receiver or --bistatic-angle, found both");
    receiver.kind = Receiver::Kind::bistatic;
    receiver.bistatic_angle_deg = number_from_words(flags.bistatic_angle, "--bistatic-angle");
    if (std::abs(receiver.bistatic_angle_deg) > 180.0)
      throw InputError(fmt::format("--bistatic-angle: expected -180..180 deg, found {}", flags.bistatic_angle));
    receiver.plane = flags.plane == "elevation" ? Receiver::Plane::elevation : Receiver::Plane::azimuth;
    return receiver;
  }
  if (flags.given("--plane")) throw InputError("--plane: belongs to --bistatic-angle, which is missing");
  if (flags.receiver == "monostatic") return receiver;
  if (flags.receiver.find(',') == std::string::npos)
    throw InputError(
        fmt::format("--receiver: expected monostatic or AZIMUTH,ELEVATION in deg, found '{}'", flags.receiver));
  receiver.kind = Receiver::Kind::fixed;
  receiver.fixed = angle_pair_from_words(flags.receiver, "--receiver");
  return receiver;
}

double wavelength_from(const SceneFlags& flags) {
  try {
    return flags.given("--wavelength") ? length_from_text(flags.wavelength) : 0.0;
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
  if (words.find(',') == std::string::npos)
    throw InputError(fmt::format("--facets: expected none, all or AZ,EL;AZ,EL... in deg, found '{}'", words));
  for (const auto& pair : split(words, ';')) {
    facets.directions.push_back(angle_pair_from_words(pair, "--facets"));
    facets.places.push_back(Place{"--facets"});
  }
  return facets;
}

std::vector<AspectAngles> directions_from(const SceneFlags& flags) {
  const auto azimuths = angles_from_words(flags.azimuth, "--azimuth", azimuth_domain);
  const auto elevations = angles_from_words(flags.elevation, "--elevation", elevation_domain);
  if (azimuths.size() * elevations.size() > most_directions)
    throw InputError(fmt::format("--elevation: the sweep has more than {} directions", most_directions));
  std::vector<AspectAngles> directions;
  for (const double elevation : elevations)
    for (const double azimuth : azimuths) directions.push_back({azimuth, elevation});
  return directions;
}

// Every word that decides a number of the result.
std::string digest_of_words(const SceneFlags& flags, const Material& material) {
  const std::vector<std::string> said{
      flags.unit,   material_to_yaml(material), flags.azimuth,     flags.elevation, flags.receiver, flags.wavelength,
      flags.plane,  flags.bistatic_angle,       flags.forward,     flags.up,        flags.sides,    flags.repair,
      flags.facets, flags.chord_tolerance,      flags.chord_angle, flags.curved};
  return digest_of(fmt::format("{}", fmt::join(said, "\n")));
}

void require_the_needed(const std::string& target, const SceneFlags& flags) {
  std::error_code none;
  if (!std::filesystem::exists(target, none))
    throw InputError(Place{target}, "no such file (a scene file ends in .yaml)");
  if (flags.unit.empty() && !has_unit(target))
    throw InputError(fmt::format("--unit is missing: {} has no unit of its own; expected one of {}", target,
                                 fmt::join(length_units(), ", ")));
  if (flags.material.empty())
    throw InputError("--material is missing: expected lambert:REFLECTANCE, a library name or a file");
  if (flags.azimuth.empty()) throw InputError("--azimuth is missing: expected A, A,B,C or FROM:TO:STEP in deg");
}

}  // namespace

void SceneFlags::add_to(CLI::App& verb) {
  const auto axis = one_of({"+x", "-x", "+y", "-y", "+z", "-z", "x", "y", "z"});
  const auto add = [&](const char* name, std::string& word, const char* meaning) {
    CLI::Option* option = verb.add_option(name, word, meaning)->group("Instead of a scene file");
    options.push_back(option);
    return option;
  };
  add("--unit", unit, "Unit of the target's coordinates (mm, m, inch, ...)");
  add("--material", material, "lambert:REFLECTANCE, a library name, or a material file");
  add("--azimuth", azimuth, "A, A,B,C or FROM:TO:STEP [deg]");
  add("--elevation", elevation, "The same (default 0)");
  add("--receiver", receiver, "monostatic (default), or AZIMUTH,ELEVATION of a fixed receiver [deg]");
  add("--bistatic-angle", bistatic_angle, "True angle between transmitter and receiver [deg]");
  add("--plane", plane, "Plane of the bistatic angle (default azimuth)")->check(one_of({"azimuth", "elevation"}));
  add("--chord-tolerance", chord_tolerance,
      "How far facets may lie off CAD surfaces: of a part's size (default 1e-3), or a length");
  add("--chord-angle", chord_angle, "Largest turn from facet to facet of CAD surfaces [deg] (default 8)");
  add("--wavelength", wavelength, "With its unit: \"1.06 um\"");
  add("--forward", forward, "File axis that is the nose (default +x; glTF: +z)")->check(axis);
  add("--up", up, "File axis that is up (default +z; glTF: +y)")->check(axis);
  add("--sides", sides, "Sides that reflect (default both)")->check(one_of({"both", "front"}));
  add("--repair", repair, "Repair the mesh (default auto)")->check(one_of({"auto", "none"}));
  add("--curved", curved,
      "Integrate over CAD surfaces themselves (auto, the default), over flat facets (none), or over smooth surfaces "
      "through the facets' corners: but where facets turn by more than an angle [deg] (crease:ANGLE), or with the "
      "normals that the file gives there (file_normals)");
  add("--facets", facets, "Facet files: none (default), all, or AZ,EL;AZ,EL... [deg]");
}

bool SceneFlags::given(const std::string& flag) const {
  for (const CLI::Option* option : options)
    if (option->get_name() == flag) return option->count() > 0;
  return false;
}

std::string SceneFlags::first_given() const {
  for (const CLI::Option* option : options)
    if (option->count() > 0) return option->get_name();
  return "";
}

Scene scene_from_flags(const std::string& target, const SceneFlags& flags) {
  require_the_needed(target, flags);
  Scene scene;
  scene.name = "command line";
  scene.target.file = target;
  scene.target.place = Place{target};
  if (!flags.unit.empty()) scene.target.unit = checked_unit(flags.unit, Place{"--unit"});
  if (!flags.chord_tolerance.empty())
    set_chord_tolerance(scene.target.tessellation, flags.chord_tolerance, Place{"--chord-tolerance"});
  if (!flags.chord_angle.empty())
    set_chord_angle(scene.target.tessellation, number_from_words(flags.chord_angle, "--chord-angle"),
                    Place{"--chord-angle"});
  const FileAxes axes = axes_of(target);
  scene.target.forward = flags.forward.empty() ? axes.forward : flags.forward;
  scene.target.up = flags.up.empty() ? axes.up : flags.up;
  if (scene.target.forward.back() == scene.target.up.back())
    throw InputError(
        fmt::format("--up: expected another axis than --forward {}, found {}", scene.target.forward, scene.target.up));
  scene.target.repair = flags.repair == "auto";
  scene.target.tessellation.curving = curving_from_words(flags.curved, Place{"--curved"});
  scene.target.sides = flags.sides == "front" ? Sides::front : Sides::both;
  scene.wavelength = wavelength_from(flags);
  scene.materials = {material_from_argument(flags.material)};
  scene.assign = {{AssignRule::By::everything, "", scene.materials.front().name, Place{"--material"}}};
  scene.directions = directions_from(flags);
  scene.receiver = receiver_from(flags);
  scene.facets = facets_from(flags.facets);
  scene.digest = digest_of_words(flags, scene.materials.front());
  return scene;
}

}  // namespace lrcs
