#include "lrcs/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <stdexcept>

#include "base/digest.h"
#include "base/length.h"
#include "base/located_yaml.h"
#include "base/nearest_name.h"
#include "brdf/material_yaml.h"
#include "lrcs/sweep_yaml.h"
#include "mesh/file_format.h"

namespace lrcs {
namespace {

TargetFile target_from_yaml(const LocatedYaml& node, const std::filesystem::path& folder) {
  node.allow_keys({"file", "unit", "forward", "up", "sides", "repair", "curved", "chord_tolerance", "chord_angle",
                   "facet_properties"});
  TargetFile target;
  target.file = folder / node.at("file").text();
  target.place = node.at("file").place();
  if (node.has("unit"))
    target.unit = checked_unit(node.at("unit").text(), node.at("unit").place());
  else if (!has_unit(target.file))
    node.fail(fmt::format("key 'unit' is missing: {} has no unit of its own; expected one of {}",
                          node.at("file").text(), fmt::join(length_units(), ", ")));
  if (node.has("chord_tolerance"))
    set_chord_tolerance(target.tessellation, node.at("chord_tolerance").text(), node.at("chord_tolerance").place());
  if (node.has("chord_angle"))
    set_chord_angle(target.tessellation, node.at("chord_angle").number(), node.at("chord_angle").place());
  const FileAxes axes = axes_of(target.file);
  target.forward = axes.forward;
  target.up = axes.up;
  if (node.has("forward"))
    target.forward = node.at("forward").one_of({"+x", "-x", "+y", "-y", "+z", "-z", "x", "y", "z"});
  if (node.has("up")) target.up = node.at("up").one_of({"+x", "-x", "+y", "-y", "+z", "-z", "x", "y", "z"});
  if (target.forward.back() == target.up.back())
    node.at(node.has("up") ? "up" : "forward")
        .fail(fmt::format("expected forward and up along different axes, found {} and {}", target.forward, target.up));
  if (node.has("sides") && node.at("sides").one_of({"both", "front"}) == "front") target.sides = Sides::front;
  if (node.has("curved"))
    target.tessellation.curving = curving_from_words(node.at("curved").text(), node.at("curved").place());
  if (node.has("facet_properties")) {
    target.facet_properties = folder / node.at("facet_properties").text();
    target.properties_place = node.at("facet_properties").place();
  }
  if (node.has("repair")) target.repair = node.at("repair").one_of({"auto", "none"}) == "auto";
  return target;
}

std::vector<std::string> names_of(const std::vector<Material>& materials) {
  std::vector<std::string> names;
  names.reserve(materials.size());
  for (const Material& m : materials) names.push_back(m.name);
  return names;
}

const std::map<std::string, AssignRule::By> keys_of_patterns{{"part", AssignRule::By::part},
                                                             {"file_material", AssignRule::By::file_material},
                                                             {"colour", AssignRule::By::colour},
                                                             {"layer", AssignRule::By::layer},
                                                             {"property", AssignRule::By::property}};
const std::string key_of_everything = "default";

std::string key_of_pattern(const LocatedYaml& rule) {
  std::string found;
  for (const auto& [key, by] : keys_of_patterns) {
    if (!rule.has(key)) continue;
    if (!found.empty()) rule.key_place(key).fail(fmt::format("expected either {} or {}, found both", found, key));
    found = key;
  }
  if (found.empty())
    rule.fail(
        "expected {part: PATTERN, material: NAME}, the same with file_material, colour or layer, {property: NAME, "
        "value: "
        "PATTERN, material: NAME}, or {default: NAME}");
  return found;
}

std::string material_at(const LocatedYaml& node, const std::vector<std::string>& materials) {
  std::string name = node.text();
  if (std::find(materials.begin(), materials.end(), name) == materials.end())
    node.fail(fmt::format("unknown material '{}'{} (materials: {})", name, did_you_mean(name, materials),
                          fmt::join(materials, ", ")));
  return name;
}

AssignRule rule_from_yaml(const LocatedYaml& node, const std::vector<std::string>& materials, Sides sides) {
  node.allow_keys({"part", "file_material", "colour", "layer", "property", "value", "material", "default", "back"});
  AssignRule rule;
  std::string key = "material";
  if (node.has("default")) {
    key = "default";
    for (const auto* other : {"part", "file_material", "colour", "layer", "property", "value", "material"})
      if (node.has(other)) node.key_place(other).fail(fmt::format("expected either default or {}, found both", other));
    rule.place = node.at("default").place();
  } else {
    const std::string by = key_of_pattern(node);
    rule.by = keys_of_patterns.at(by);
    const bool by_property = rule.by == AssignRule::By::property;
    if (by_property) rule.property = node.at(by).text();
    if (!by_property && node.has("value")) node.key_place("value").fail("value belongs to property, which is missing");
    const LocatedYaml pattern = node.at(by_property ? "value" : by);
    rule.pattern = pattern.text();
    rule.place = pattern.place();
  }
  rule.material = material_at(node.at(key), materials);
  if (!node.has("back")) return rule;
  if (sides == Sides::front) node.key_place("back").fail("with 'sides: front' no back is seen, expected no such key");
  rule.back = material_at(node.at("back"), materials);
  return rule;
}

// Names stand in comment lines of results.
Material material_of(const std::string& name, const LocatedYaml& node, const LocatedYaml& key) {
  const bool one_line =
      std::none_of(name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
  if (name.empty() || !one_line) key.fail("expected a material's name on one line");
  if (!node.is_map())
    node.fail(fmt::format("material '{}': expected {{library: NAME}} or {{model: NAME, ...}}, found {}", name,
                          found_in(node)));
  return material_from_yaml(node, name);
}

std::vector<Material> materials_from_yaml(const LocatedYaml& node) {
  std::vector<Material> materials;
  for (const auto& [name, value] : node.entries()) materials.push_back(material_of(name, value, node.key_place(name)));
  if (materials.empty()) node.fail("expected at least one material");
  return materials;
}

FacetOutput facets_from_yaml(const LocatedYaml& node) {
  FacetOutput facets;
  if (node.is_scalar()) {
    facets.all = node.one_of({"none", "all"}) == "all";
    return facets;
  }
  if (!node.is_sequence())
    node.fail(
        fmt::format("expected none, all, or a list of {{azimuth: A, elevation: E}} in deg, found {}", found_in(node)));
  for (const auto& item : node.items()) {
    facets.directions.push_back(angles_from_yaml(item));
    facets.places.push_back(item.place());
  }
  return facets;
}

double wavelength_from_yaml(const LocatedYaml& node) {
  try {
    return length_from_text(node.text());
  } catch (const std::invalid_argument& wrong) {
    node.fail(wrong.what());
  }
}

std::optional<double> accuracy_from_yaml(const LocatedYaml& node) {
  if (!node.is_map()) {
    if (!node.is_scalar() || node.text() != "exact")
      node.fail(fmt::format("expected exact or {{relative: 1e-3}}, found {}", found_in(node)));
    return std::nullopt;
  }
  node.allow_keys({"relative"});
  const LocatedYaml relative = node.at("relative");
  const double value = relative.number();
  if (!(value > 0.0 && value < 1.0))
    relative.fail(fmt::format("expected a number between 0 and 1, found {}", relative.text()));
  return value;
}

// The same angles come first: straight up and down every azimuth points the same way.
std::size_t nearest_row(const AspectAngles& asked, const std::vector<AspectAngles>& directions) {
  const auto same = std::find(directions.begin(), directions.end(), asked);
  if (same != directions.end()) return static_cast<std::size_t>(same - directions.begin());
  const Vec3 d = direction_of(asked);
  double nearest = 4.0;
  std::size_t row = 0;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const double apart = (direction_of(directions[k]) - d).norm();
    if (apart < nearest) {
      nearest = apart;
      row = k;
    }
  }
  return row;
}

void check_version(const LocatedYaml& yaml) {
  if (!yaml.has("lrcs")) yaml.fail("key 'lrcs' is missing: expected 'lrcs: 1', the version of the format");
  const LocatedYaml wanted = yaml.at("lrcs");
  if (wanted.number() != 1.0) wanted.fail(fmt::format("expected format version 1, found {}", wanted.text()));
}

}  // namespace

std::string checked_unit(const std::string& unit, const Place& place) {
  try {
    (void)metres_in(unit);
    return unit;
  } catch (const std::invalid_argument& wrong) {
    throw InputError(place, wrong.what());
  }
}

void set_chord_tolerance(Tessellation& tessellation, const std::string& words, const Place& place) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(words.data(), words.data() + words.size(), number);
  if (error == std::errc() && end == words.data() + words.size()) {
    if (!(number >= 1e-7 && number <= 0.5))
      throw InputError(place, fmt::format("expected a chord tolerance of 1e-7..0.5 of a part, found {}", words));
    tessellation.relative = number;
    return;
  }
  try {
    tessellation.absolute = length_from_text(words);
  } catch (const std::invalid_argument& wrong) {
    throw InputError(place, wrong.what());
  }
}

void set_chord_angle(Tessellation& tessellation, double angle_deg, const Place& place) {
  if (!(angle_deg >= 0.1 && angle_deg <= 90.0))
    throw InputError(place, fmt::format("expected 0.1..90 deg from edge to edge, found {}", angle_deg));
  tessellation.angle_deg = angle_deg;
}

const std::string& key_of(AssignRule::By by) {
  for (const auto& [key, its_by] : keys_of_patterns)
    if (its_by == by) return key;
  return key_of_everything;
}

Scene read_scene(const std::filesystem::path& file) {
  const LocatedYaml yaml = LocatedYaml::of_file(file);
  yaml.allow_keys({"lrcs", "wavelength", "target", "materials", "assign", "sweep", "receiver", "accuracy", "output"});
  check_version(yaml);
  Scene scene;
  scene.name = file.string();
  scene.digest = digest_of_file(file);
  if (yaml.has("wavelength")) scene.wavelength = wavelength_from_yaml(yaml.at("wavelength"));
  scene.target = target_from_yaml(yaml.at("target"), file.parent_path());
  scene.materials = materials_from_yaml(yaml.at("materials"));
  const auto names = names_of(scene.materials);
  const LocatedYaml assign = yaml.at("assign");
  scene.assign_place = assign.place();
  for (const auto& item : assign.items()) scene.assign.push_back(rule_from_yaml(item, names, scene.target.sides));
  scene.directions = sweep_from_yaml(yaml.at("sweep"));
  if (yaml.has("receiver")) scene.receiver = receiver_from_yaml(yaml.at("receiver"));
  if (yaml.has("accuracy")) scene.relative_accuracy = accuracy_from_yaml(yaml.at("accuracy"));
  if (yaml.has("output")) {
    yaml.at("output").allow_keys({"facets"});
    if (yaml.at("output").has("facets")) scene.facets = facets_from_yaml(yaml.at("output").at("facets"));
  }
  return scene;
}

std::vector<std::size_t> facet_rows(const Scene& scene) {
  // Angles that print the same to a user are the same: from + k step need not hit the double nearest to the decimals.
  constexpr double same_deg = 1.0 / 1048576.0;
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < scene.facets.directions.size(); ++k) {
    const AspectAngles& asked = scene.facets.directions[k];
    const std::size_t row = nearest_row(asked, scene.directions);
    const AspectAngles& found = scene.directions[row];
    if ((direction_of(found) - direction_of(asked)).norm() > same_deg * degree)
      throw InputError(
          scene.facets.places[k],
          fmt::format("azimuth {}, elevation {} is no direction of the sweep; the nearest is azimuth {}, elevation {}",
                      asked.azimuth_deg, asked.elevation_deg, found.azimuth_deg, found.elevation_deg));
    rows.push_back(row);
  }
  return rows;
}

std::vector<std::string> wavelength_warnings(const Scene& scene) {
  // Wavelengths are told apart to a millionth: finer than any laser line is quoted.
  constexpr double same = 1.0 / 1048576.0;
  std::vector<std::string> warnings;
  for (const Material& m : scene.materials) {
    if (m.wavelength == 0.0 || scene.wavelength == 0.0) continue;
    if (std::abs(m.wavelength - scene.wavelength) <= same * scene.wavelength) continue;
    warnings.push_back(fmt::format("material '{}' is for {}, the scene is at {}", m.name,
                                   text_of_length(m.wavelength, "um"), text_of_length(scene.wavelength, "um")));
  }
  return warnings;
}

std::vector<std::string> material_warnings(const Scene& scene) {
  std::vector<std::string> warnings = wavelength_warnings(scene);
  for (const Material& m : scene.materials)
    if (const auto* tabulated = std::get_if<Tabulated>(&m.brdf))
      for (const std::string& warning : tabulated->measurement().warnings)
        warnings.push_back(fmt::format("material '{}': {}", m.name, warning));
  return warnings;
}

}  // namespace lrcs
