#include "lrcs/scene_yaml.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/length.h"
#include "base/path_from.h"
#include "brdf/material_yaml.h"
#include "brdf/yaml_words.h"
#include "lrcs/aspect_grid.h"

namespace lrcs {
namespace {

using Folder = std::filesystem::path;

std::string target_to_yaml(const TargetFile& target, const Folder& folder) {
  std::string yaml = fmt::format("target:\n  file: {}\n", quoted_yaml(path_from(folder, target.file)));
  if (!target.unit.empty()) yaml += fmt::format("  unit: {}\n", target.unit);
  yaml += fmt::format("  forward: \"{}\"\n  up: \"{}\"\n", target.forward, target.up);
  yaml += fmt::format("  sides: {}\n", target.sides == Sides::front ? "front" : "both");
  yaml += fmt::format("  repair: {}\n", target.repair ? "auto" : "none");
  const Tessellation& t = target.tessellation;
  yaml += fmt::format("  curved: {}\n  chord_angle: {}\n", quoted_yaml(text_of(t.curving)), t.angle_deg);
  yaml += fmt::format("  chord_tolerance: {}\n",
                      t.absolute ? text_of_length(*t.absolute, "m") : fmt::format("{}", t.relative));
  if (!target.facet_properties.empty())
    yaml += fmt::format("  facet_properties: {}\n", quoted_yaml(path_from(folder, target.facet_properties)));
  return yaml;
}

std::string named_material_to_yaml(const Material& material, const Folder& folder) {
  std::string yaml = fmt::format("  {}:\n", quoted_yaml(material.name));
  const std::string definition = material_to_yaml(material, folder);
  for (std::size_t from = 0; from < definition.size();) {
    const std::size_t to = std::min(definition.find('\n', from), definition.size());
    yaml += fmt::format("    {}\n", definition.substr(from, to - from));
    from = to + 1;
  }
  return yaml;
}

std::string rule_to_yaml(const AssignRule& rule) {
  using By = AssignRule::By;
  std::string yaml = fmt::format("  - {}: ", key_of(rule.by));
  const std::string material = quoted_yaml(rule.material);
  if (rule.by == By::everything)
    yaml += material + "\n";
  else if (rule.by == By::property)
    yaml += fmt::format("{}\n    value: {}\n    material: {}\n", quoted_yaml(rule.property), quoted_yaml(rule.pattern),
                        material);
  else
    yaml += fmt::format("{}\n    material: {}\n", quoted_yaml(rule.pattern), material);
  if (!rule.back.empty()) yaml += fmt::format("    back: {}\n", quoted_yaml(rule.back));
  return yaml;
}

std::string sweep_to_yaml(const std::vector<AspectAngles>& directions) {
  const std::size_t azimuths = azimuths_of_grid(directions);
  std::vector<std::string> words;
  if (azimuths == 0) {
    for (const auto& [azimuth, elevation] : directions) words.push_back(fmt::format("[{}, {}]", azimuth, elevation));
    return fmt::format("sweep:\n  directions: [{}]\n", fmt::join(words, ", "));
  }
  std::vector<double> azimuth, elevation;
  for (std::size_t k = 0; k < azimuths; ++k) azimuth.push_back(directions[k].azimuth_deg);
  for (std::size_t k = 0; k < directions.size(); k += azimuths) elevation.push_back(directions[k].elevation_deg);
  return fmt::format("sweep:\n  azimuth: [{}]\n  elevation: [{}]\n", fmt::join(azimuth, ", "),
                     fmt::join(elevation, ", "));
}

std::string receiver_to_yaml(const Receiver& receiver) {
  switch (receiver.kind) {
    case Receiver::Kind::fixed:
      return fmt::format("receiver: {{azimuth: {}, elevation: {}}}\n", receiver.fixed.azimuth_deg,
                         receiver.fixed.elevation_deg);
    case Receiver::Kind::bistatic:
      return fmt::format("receiver: {{bistatic_angle: {}, plane: {}}}\n", receiver.bistatic_angle_deg,
                         receiver.plane == Receiver::Plane::azimuth ? "azimuth" : "elevation");
    default:
      return "receiver: monostatic\n";
  }
}

std::string facets_to_yaml(const FacetOutput& facets) {
  if (facets.all) return "output: {facets: all}\n";
  std::string yaml = facets.directions.empty() ? "" : "output:\n  facets:\n";
  for (const auto& [azimuth, elevation] : facets.directions)
    yaml += fmt::format("    - {{azimuth: {}, elevation: {}}}\n", azimuth, elevation);
  return yaml;
}

}  // namespace

std::string scene_to_yaml(const Scene& scene, const std::filesystem::path& folder) {
  std::string yaml = "lrcs: 1\n";
  if (scene.wavelength > 0.0) yaml += fmt::format("wavelength: {}\n", text_of_length(scene.wavelength, "um"));
  yaml += target_to_yaml(scene.target, folder);
  yaml += "materials:\n";
  for (const Material& m : scene.materials) yaml += named_material_to_yaml(m, folder);
  yaml += "assign:\n";
  for (const AssignRule& rule : scene.assign) yaml += rule_to_yaml(rule);
  yaml += sweep_to_yaml(scene.directions) + receiver_to_yaml(scene.receiver);
  yaml += scene.relative_accuracy ? fmt::format("accuracy: {{relative: {}}}\n", *scene.relative_accuracy)
                                  : "accuracy: exact\n";
  return yaml + facets_to_yaml(scene.facets);
}

}  // namespace lrcs
