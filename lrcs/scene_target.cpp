#include "lrcs/scene_target.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>

#include "base/digest.h"
#include "base/nearest_name.h"
#include "mesh/body_frame.h"
#include "mesh/read_mesh.h"

namespace lrcs {
namespace {

constexpr std::uint32_t unassigned = 0xffffffff;

// Shown at most, of a target's many names.
constexpr std::size_t most_names = 12;

// "" is a part or material that the file gives no name.
std::string shown(const std::string& name) {
  return name.empty() ? "one without a name" : fmt::format("'{}'", name);
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t k = 0; k < std::min(names.size(), most_names); ++k)
    text += fmt::format("{}{}", k == 0 ? "" : ", ", shown(names[k]));
  return names.size() > most_names ? fmt::format("{} and {} more", text, names.size() - most_names) : text;
}

// Does the rule match each of the names? An error if it matches none.
std::vector<bool> matches(const AssignRule& rule, const std::vector<std::string>& names) {
  std::vector<bool> matched;
  matched.reserve(names.size());
  for (const auto& name : names) matched.push_back(fnmatch(rule.pattern.c_str(), name.c_str(), 0) == 0);
  if (std::find(matched.begin(), matched.end(), true) == matched.end()) {
    const bool part = rule.by == AssignRule::By::part;
    throw InputError(rule.place, fmt::format("pattern '{}' matches no {} of the target{} ({}: {})", rule.pattern,
                                             part ? "part" : "material", did_you_mean(rule.pattern, names),
                                             part ? "parts" : "materials in the file", listed(names)));
  }
  return matched;
}

std::uint32_t index_of(const std::string& name, const std::vector<Material>& materials) {
  const auto found =
      std::find_if(materials.begin(), materials.end(), [&](const Material& m) { return m.name == name; });
  return static_cast<std::uint32_t>(found - materials.begin());
}

}  // namespace

std::vector<std::uint32_t> assign_materials(const FacetMesh& mesh, const Scene& scene) {
  std::vector<std::uint32_t> material(mesh.size(), unassigned);
  for (const AssignRule& rule : scene.assign) {
    const std::uint32_t index = index_of(rule.material, scene.materials);
    const bool everything = rule.by == AssignRule::By::everything;
    const bool by_part = rule.by == AssignRule::By::part;
    const auto matched =
        everything ? std::vector<bool>{} : matches(rule, by_part ? mesh.part_names : mesh.file_material_names);
    for (std::size_t k = 0; k < mesh.size(); ++k)
      if (material[k] == unassigned && (everything || matched[by_part ? mesh.part[k] : mesh.file_material[k]]))
        material[k] = index;
  }
  const auto left_out = std::find(material.begin(), material.end(), unassigned);
  if (left_out != material.end()) {
    const auto k = static_cast<std::size_t>(left_out - material.begin());
    const std::string& of = mesh.file_material_names[mesh.file_material[k]];
    throw InputError(
        scene.assign_place,
        fmt::format("{} of {} facets have no material, the first in part {}{}: expected a rule for each, or a last "
                    "rule {{default: MATERIAL}}",
                    std::count(material.begin(), material.end(), unassigned), mesh.size(),
                    shown(mesh.part_names[mesh.part[k]]), of.empty() ? "" : fmt::format(", file material '{}'", of)));
  }
  return material;
}

LoadedTarget load_target(const Scene& scene) {
  std::error_code none;
  if (!std::filesystem::exists(scene.target.file, none))
    throw InputError(scene.target.place, fmt::format("no such file: '{}'", scene.target.file.string()));
  LoadedTarget loaded;
  Target& target = loaded.target;
  loaded.digest = digest_of_file(scene.target.file);
  target.mesh = read_mesh(scene.target.file);
  if (scene.target.repair) loaded.repaired = repair(target.mesh);
  place_in_body_frame(target.mesh, scene.target.metres_per_unit, scene.target.forward, scene.target.up);
  target.materials = scene.materials;
  target.sides = scene.target.sides;
  target.material = assign_materials(target.mesh, scene);
  return loaded;
}

}  // namespace lrcs
