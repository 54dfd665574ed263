#include "lrcs/scene_target.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <numbers>
#include <utility>

#include "base/digest.h"
#include "base/length.h"
#include "base/nearest_name.h"
#include "cad/read_target.h"
#include "mesh/body_frame.h"
#include "mesh/corner_normals.h"
#include "mesh/facet_properties_csv.h"
#include "mesh/normal_patches.h"

namespace lrcs {
namespace {

constexpr std::uint32_t unassigned = 0xffffffff;

// Shown at most, of a target's many names.
constexpr std::size_t most_names = 12;

// "" is a part or material that the file gives no name.
std::string quoted(const std::string& name) {
  return name.empty() ? "one without a name" : fmt::format("'{}'", name);
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t k = 0; k < std::min(names.size(), most_names); ++k)
    text += fmt::format("{}{}", k == 0 ? "" : ", ", quoted(names[k]));
  return names.size() > most_names ? fmt::format("{} and {} more", text, names.size() - most_names) : text;
}

struct Words {
  std::string one, all;
};

Words words_of(const AssignRule& rule) {
  switch (rule.by) {
    case AssignRule::By::file_material:
      return {"material", "materials in the file"};
    case AssignRule::By::colour:
      return {"colour", "colours"};
    case AssignRule::By::layer:
      return {"layer", "layers"};
    case AssignRule::By::property:
      return {"value of " + rule.property, "values"};
    default:
      return {"part", "parts"};
  }
}

const FacetNames& property_of(const FacetMesh& mesh, const AssignRule& rule) {
  std::vector<std::string> names;
  for (const FacetProperty& property : mesh.properties) {
    if (property.name == rule.property) return property.values;
    names.push_back(property.name);
  }
  throw InputError(rule.place, fmt::format("the target has no facet property '{}'{} (properties: {})", rule.property,
                                           did_you_mean(rule.property, names), names.empty() ? "none" : listed(names)));
}

// What the file tells facets that the rule goes by.
const FacetNames& told_by(const AssignRule& rule, const FacetMesh& mesh) {
  switch (rule.by) {
    case AssignRule::By::file_material:
      return mesh.file_material;
    case AssignRule::By::colour:
      return mesh.colour;
    case AssignRule::By::layer:
      return mesh.layer;
    case AssignRule::By::property:
      return property_of(mesh, rule);
    default:
      return mesh.part;
  }
}

// Hexadecimal digits have no case.
int flags_of(AssignRule::By by) {
  return by == AssignRule::By::colour ? FNM_CASEFOLD : 0;
}

// Does the rule match each of the names? An error if it matches none.
std::vector<bool> matches(const AssignRule& rule, const std::vector<std::string>& names) {
  std::vector<bool> matched;
  matched.reserve(names.size());
  for (const auto& name : names) matched.push_back(fnmatch(rule.pattern.c_str(), name.c_str(), flags_of(rule.by)) == 0);
  if (std::find(matched.begin(), matched.end(), true) == matched.end()) {
    const Words words = words_of(rule);
    throw InputError(rule.place, fmt::format("pattern '{}' matches no {} of the target{} ({})", rule.pattern, words.one,
                                             did_you_mean(rule.pattern, names),
                                             names.empty() ? fmt::format("the file has no {}", words.all)
                                                           : fmt::format("{}: {}", words.all, listed(names))));
  }
  return matched;
}

const std::string& name_of(const FacetNames& told, std::size_t facet) {
  static const std::string none;
  return told.of.empty() ? none : told.names[told.of[facet]];
}

// ", file material 'Gold', colour '#c0c0c0'"
std::string also_told(const FacetMesh& mesh, std::size_t facet) {
  std::string text;
  const auto add = [&](const char* what, const std::string& name) {
    if (!name.empty()) text += fmt::format(", {} '{}'", what, name);
  };
  add("file material", name_of(mesh.file_material, facet));
  add("colour", name_of(mesh.colour, facet));
  add("layer", name_of(mesh.layer, facet));
  return text;
}

std::uint32_t index_of(const std::string& name, const std::vector<Material>& materials) {
  const auto found =
      std::find_if(materials.begin(), materials.end(), [&](const Material& m) { return m.name == name; });
  return static_cast<std::uint32_t>(found - materials.begin());
}

void require_file(const std::filesystem::path& file, const Place& place) {
  std::error_code none;
  if (!std::filesystem::exists(file, none)) throw InputError(place, fmt::format("no such file: '{}'", file.string()));
}

}  // namespace

FacetMaterials assign_materials(const FacetMesh& mesh, const Scene& scene) {
  std::vector<std::uint32_t> material(mesh.size(), unassigned), back(mesh.size());
  for (const AssignRule& rule : scene.assign) {
    const std::uint32_t index = index_of(rule.material, scene.materials);
    const std::uint32_t behind = rule.back.empty() ? index : index_of(rule.back, scene.materials);
    const bool everything = rule.by == AssignRule::By::everything;
    const FacetNames& told = told_by(rule, mesh);
    const auto matched = everything ? std::vector<bool>{} : matches(rule, told.names);
    for (std::size_t k = 0; k < mesh.size(); ++k) {
      if (material[k] != unassigned || !(everything || matched[told.of[k]])) continue;
      material[k] = index;
      back[k] = behind;
    }
  }
  const auto left_out = std::find(material.begin(), material.end(), unassigned);
  if (left_out != material.end()) {
    const auto k = static_cast<std::size_t>(left_out - material.begin());
    throw InputError(
        scene.assign_place,
        fmt::format("{} of {} facets have no material, the first in part {}{}: expected a rule for each, or a last "
                    "rule {{default: MATERIAL}}",
                    std::count(material.begin(), material.end(), unassigned), mesh.size(),
                    quoted(name_of(mesh.part, k)), also_told(mesh, k)));
  }
  if (back == material) back.clear();
  return {std::move(material), std::move(back)};
}

namespace {

void curve_by_creases(FacetMesh& mesh, double crease_deg, std::vector<std::string>& warnings) {
  const auto unknown = curve_by_normals(mesh, estimated_normals(mesh, crease_deg * std::numbers::pi / 180.0));
  if (mesh.curved.patches.empty())
    warnings.push_back(
        fmt::format("crease:{} bends no facet: none shares an edge with another that turns by less, or "
                    "they are not welded (repair: none)",
                    crease_deg));
  if (!unknown.empty())
    warnings.push_back(
        fmt::format("{} facets stay flat: they turn by more than 60 deg within crease:{}", unknown.size(), crease_deg));
}

}  // namespace

LoadedTarget load_target(const Scene& scene) {
  const std::filesystem::path& properties = scene.target.facet_properties;
  require_file(scene.target.file, scene.target.place);
  if (!properties.empty()) require_file(properties, scene.target.properties_place);
  LoadedTarget loaded;
  Target& target = loaded.target;
  loaded.digest = digest_of_file(scene.target.file);
  TargetRead read = read_target(scene.target.file, scene.target.unit, scene.target.tessellation);
  if (read.unit.empty())
    throw InputError(scene.target.place,
                     fmt::format("'{}' says no unit that is known here, expected the key or flag for it: one of {}",
                                 scene.target.file.string(), fmt::join(length_units(), ", ")));
  target.mesh = std::move(read.mesh);
  loaded.unit = read.unit;
  loaded.tessellation = read.tessellation;
  loaded.warnings = read.warnings;
  if (!properties.empty()) {
    add_facet_properties(target.mesh, properties);
    loaded.properties_digest = digest_of_file(properties);
  }
  if (scene.target.repair) loaded.repaired = repair(target.mesh);
  place_in_body_frame(target.mesh, target.mesh.metres_per_unit, scene.target.forward, scene.target.up);
  if (scene.target.tessellation.curving.by == Curving::By::estimated_normals)
    curve_by_creases(target.mesh, scene.target.tessellation.curving.crease_deg, loaded.warnings);
  target.curved = CurvedSurface(target.mesh);
  target.materials = scene.materials;
  target.sides = scene.target.sides;
  FacetMaterials materials = assign_materials(target.mesh, scene);
  target.material = std::move(materials.front);
  target.back = std::move(materials.back);
  return loaded;
}

}  // namespace lrcs
