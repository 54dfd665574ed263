#include "lrcs/manifest.h"

#include <nlohmann/json.hpp>

#include "base/version.h"
#include "brdf/material_yaml.h"

namespace lrcs {
namespace {

using Json = nlohmann::ordered_json;

Json properties_json(const Scene& scene, const LoadedTarget& loaded) {
  if (loaded.properties_digest.empty()) return nullptr;
  return {{"file", scene.target.facet_properties.string()}, {"sha256", loaded.properties_digest}};
}

Json target_json(const Scene& scene, const LoadedTarget& loaded) {
  const RepairCounts& r = loaded.repaired;
  return {{"file", scene.target.file.string()},
          {"sha256", loaded.digest},
          {"facet_properties", properties_json(scene, loaded)},
          {"unit", loaded.unit},
          {"tessellation", loaded.tessellation.empty() ? Json(nullptr) : Json(loaded.tessellation)},
          {"forward", scene.target.forward},
          {"up", scene.target.up},
          {"sides", scene.target.sides == Sides::front ? "front" : "both"},
          {"facets", loaded.target.mesh.size()},
          {"repair", scene.target.repair ? "auto" : "none"},
          {"curved", text_of(scene.target.tessellation.curving)},
          {"curved_facets", loaded.target.curved.facets().size()},
          {"repaired",
           {{"welded_vertices", r.welded_vertices},
            {"degenerate", r.degenerate},
            {"duplicate", r.duplicate},
            {"flipped", r.flipped}}}};
}

Json measurement_json(const Tabulated& tabulated) {
  return {{"file", tabulated.file().path},
          {"sha256", tabulated.file().digest},
          {"format", tabulated.measurement().format},
          {"samples", tabulated.samples()},
          {"places", tabulated.places()},
          {"outside", std::string(word_of(tabulated.outside()))},
          {"notes", tabulated.measurement().notes},
          {"warnings", tabulated.measurement().warnings}};
}

Json materials_json(const LoadedTarget& loaded) {
  std::vector<std::size_t> facets(loaded.target.materials.size(), 0), backs = facets;
  for (const auto m : loaded.target.material) ++facets[m];
  for (const auto m : loaded.target.back_material()) ++backs[m];
  Json materials = Json::array();
  for (std::size_t k = 0; k < facets.size(); ++k) {
    const Material& m = loaded.target.materials[k];
    materials.push_back(
        {{"name", m.name}, {"facets", facets[k]}, {"backs", backs[k]}, {"definition", material_to_yaml(m)}});
    if (const auto* tabulated = std::get_if<Tabulated>(&m.brdf))
      materials.back()["measurement"] = measurement_json(*tabulated);
  }
  return materials;
}

// As the scene file says it.
Json assign_json(const std::vector<AssignRule>& rules) {
  Json assign = Json::array();
  for (const AssignRule& rule : rules) {
    const std::string& key = key_of(rule.by);
    Json& json = assign.emplace_back(Json::object());
    if (rule.by == AssignRule::By::everything) {
      json[key] = rule.material;
    } else {
      const bool is_property = rule.by == AssignRule::By::property;
      if (is_property) json[key] = rule.property;
      json[is_property ? "value" : key] = rule.pattern;
      json["material"] = rule.material;
    }
    if (!rule.back.empty()) json["back"] = rule.back;
  }
  return assign;
}

Json receiver_json(const Receiver& receiver) {
  switch (receiver.kind) {
    case Receiver::Kind::fixed:
      return {{"azimuth_deg", receiver.fixed.azimuth_deg}, {"elevation_deg", receiver.fixed.elevation_deg}};
    case Receiver::Kind::bistatic:
      return {{"bistatic_angle_deg", receiver.bistatic_angle_deg},
              {"plane", receiver.plane == Receiver::Plane::azimuth ? "azimuth" : "elevation"}};
    default:
      return "monostatic";
  }
}

Json facets_json(const std::vector<FacetFile>& files) {
  Json facets = Json::array();
  for (const auto& [k, row, name, aspect] : files)
    facets.push_back({{"file", name},
                      {"row", row},
                      {"transmitter_azimuth_deg", aspect.transmitter.azimuth_deg},
                      {"transmitter_elevation_deg", aspect.transmitter.elevation_deg},
                      {"receiver_azimuth_deg", aspect.receiver.azimuth_deg},
                      {"receiver_elevation_deg", aspect.receiver.elevation_deg}});
  return facets;
}

Json skipped_json(const SkipCounts& skipped) {
  return {{"convex_facets", skipped.convex_facets},
          {"hull_facets", skipped.hull_facets},
          {"free_convex_parts", skipped.free_convex_parts},
          {"parts_apart", skipped.parts_apart},
          {"facets_never_faced", skipped.facets_never_faced},
          {"facets_without_return", skipped.facets_without_return},
          {"repeated_directions", skipped.repeated_directions},
          {"mirrored_directions", skipped.mirrored_directions},
          {"mirror_planes", skipped.mirror_planes},
          {"monostatic_directions", skipped.monostatic_directions},
          {"fixed_gamma_directions", skipped.fixed_gamma_directions}};
}

// What was done, not what was allowed.
std::string method_of(const MethodCounts& rows) {
  if (rows.sampled == 0) return "exact seen area of every facet";
  return rows.exact == 0 ? "row grids" : "row grids, and exact seen area of every facet";
}

}  // namespace

std::string manifest_json(const Scene& scene, const LoadedTarget& loaded, const RunFacts& facts) {
  Json outputs = Json::array();
  for (const auto& [name, digest] : facts.outputs) outputs.push_back({{"file", name}, {"sha256", digest}});
  const Json json{{"program", "lrcs"},
                  {"version", version},
                  {"command", facts.command},
                  {"started_utc", facts.started_utc},
                  {"scene", {{"file", scene.name}, {"sha256", scene.digest}}},
                  {"wavelength_m", scene.wavelength > 0.0 ? Json(scene.wavelength) : Json(nullptr)},
                  {"target", target_json(scene, loaded)},
                  {"materials", materials_json(loaded)},
                  {"assign", assign_json(scene.assign)},
                  {"directions", scene.directions.size()},
                  {"receiver", receiver_json(scene.receiver)},
                  {"accuracy", scene.relative_accuracy ? Json{{"relative", *scene.relative_accuracy}} : Json("exact")},
                  {"method", method_of(facts.methods)},
                  {"rows", {{"exact", facts.methods.exact}, {"sampled", facts.methods.sampled}}},
                  {"threads", facts.threads},
                  {"seconds", {{"read", facts.read_seconds}, {"sweep", facts.sweep_seconds}}},
                  {"outputs", outputs},
                  {"facets", facets_json(facts.facets)},
                  {"skipped", skipped_json(facts.skipped)},
                  {"warnings", facts.warnings}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lrcs
