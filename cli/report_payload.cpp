#include "cli/report_payload.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>

#include "base/length.h"
#include "base/version.h"
#include "brdf/material_yaml.h"
#include "cli/facet_results.h"
#include "cli/plane_curves.h"
#include "cli/sweep_cuts.h"
#include "mesh/diagnosis.h"
#include "view/readable_text.h"

namespace lrcs {
namespace {

using Json = nlohmann::ordered_json;

std::string receiver_words(const Receiver& receiver) {
  switch (receiver.kind) {
    case Receiver::Kind::fixed:
      return fmt::format("fixed at azimuth {}°, elevation {}°", receiver.fixed.azimuth_deg,
                         receiver.fixed.elevation_deg);
    case Receiver::Kind::bistatic:
      return fmt::format("bistatic angle {}° in {}", receiver.bistatic_angle_deg,
                         receiver.plane == Receiver::Plane::azimuth ? "azimuth" : "elevation");
    default:
      return "monostatic";
  }
}

// What a manifest says of what was skipped: counts that are not zero.
Json skipped_facts(const Json& manifest) {
  Json facts = Json::array();
  for (const auto& [name, value] : manifest.at("skipped").get<std::map<std::string, Json>>()) {
    if (value.is_number() && value.get<double>() == 0.0) continue;
    std::string label = "Skipped: " + name;
    std::replace(label.begin(), label.end(), '_', ' ');
    const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
    if (!text.empty()) facts.push_back({label, text});
  }
  return facts;
}

Json run_json(const PastRun& run, const Json& manifest) {
  const Scene& scene = run.scene;
  const auto& relative = scene.relative_accuracy;
  return {{"command", manifest.at("command").get<std::vector<std::string>>()},
          {"started_utc", manifest.at("started_utc").get<std::string>()},
          {"scene_file", manifest.at("scene").at("file").get<std::string>()},
          {"scene_sha256", manifest.at("scene").at("sha256").get<std::string>()},
          {"wavelength_m", scene.wavelength > 0.0 ? Json(scene.wavelength) : Json(nullptr)},
          {"accuracy", relative ? fmt::format("relative {}", *relative) : "exact"},
          {"method", manifest.at("method").get<std::string>()},
          {"receiver", receiver_words(scene.receiver)},
          {"threads", manifest.at("threads").get<std::size_t>()},
          {"read_seconds", manifest.at("seconds").at("read").get<double>()},
          {"sweep_seconds", manifest.at("seconds").at("sweep").get<double>()},
          {"warnings", manifest.at("warnings").get<std::vector<std::string>>()},
          {"facts", skipped_facts(manifest)}};
}

Json diagnosis_facts(const PastRun& run, const Diagnosis& d) {
  Json facts = Json::array();
  const auto add = [&](const char* label, const std::string& text) { facts.push_back({label, text}); };
  const RepairCounts& r = run.loaded.repaired;
  add("Closed", d.closed ? "yes" : "no");
  if (d.closed) add("Volume", fmt::format("{:.6g} m³", d.volume));
  add("Parts", fmt::format("{}", d.parts.size()));
  if (!run.loaded.tessellation.empty()) add("Tessellation", run.loaded.tessellation);
  add("Repaired", fmt::format("{} repeated vertices welded, {} degenerate and {} duplicate facets dropped, {} facets "
                              "turned outward",
                              r.welded_vertices, r.degenerate, r.duplicate, r.flipped));
  const std::vector<std::pair<const char*, std::size_t>> left{
      {"Degenerate facets", d.degenerate},
      {"Duplicate facets", d.duplicate},
      {"Facets on their backs' places", d.opposite},
      {"Edges of more than two facets", d.non_manifold_edges},
      {"Edges of one facet", d.boundary_edges},
      {"Holes and outlines of sheets", d.holes},
      {"Flipped facets", d.flipped},
      {"Inward shells", d.inward_shells},
      {"T-junctions", d.t_junctions},
      {"Self-intersections (pairs of facets)", d.self_intersections.pairs}};
  for (const auto& [label, count] : left)
    if (count > 0) add(label, fmt::format("{}", count));
  constexpr std::size_t most = 8;
  for (std::size_t k = 0; k < std::min(most, d.meeting.size()); ++k)
    add("Parts that meet", fmt::format("{} and {}", d.meeting[k].one, d.meeting[k].other));
  if (d.meeting.size() > most) add("More parts that meet", fmt::format("{} pairs", d.meeting.size() - most));
  return facts;
}

Json target_json(const PastRun& run, const ShownTarget& shown) {
  const FacetMesh& mesh = run.loaded.target.mesh;
  const Diagnosis diagnosis = diagnose(mesh);
  const auto corner = [&](std::size_t k) {
    const Vec3& p = diagnosis.box[k];
    return Json{p.x(), p.y(), p.z()};
  };
  return {{"file", run.scene.target.file.filename().string()},
          {"sha256", run.loaded.digest},
          {"unit", run.loaded.unit},
          {"facets", mesh.size()},
          {"shown_facets", shown.size()},
          {"curved_facets", run.loaded.target.curved.facets().size()},
          {"box_m", {corner(0), corner(1)}},
          {"area_m2", diagnosis.area},
          {"facts", diagnosis_facts(run, diagnosis)}};
}

Json parts_json(const FacetMesh& mesh) {
  std::vector<std::size_t> facets(mesh.part.names.size(), 0);
  std::vector<double> area(facets.size(), 0.0);
  for (std::size_t k = 0; k < mesh.size(); ++k) ++facets[mesh.part.of[k]], area[mesh.part.of[k]] += mesh.areas[k];
  Json parts = Json::array();
  for (std::size_t part = 0; part < facets.size(); ++part)
    parts.push_back({{"name", readable(mesh.part.names[part])}, {"facets", facets[part]}, {"area_m2", area[part]}});
  return parts;
}

// In the plane of incidence; null where it is not known.
Json curve_json(const Brdf& brdf, double theta_i_deg, const std::vector<double>& theta_r_deg) {
  Json curve = Json::array();
  for (const double theta_r : theta_r_deg) {
    try {
      const double value = f_r_in_plane(brdf, theta_i_deg, theta_r);
      curve.push_back(std::isfinite(value) ? Json(value) : Json(nullptr));
    } catch (const NotMeasured&) {
      curve.push_back(nullptr);
    }
  }
  return curve;
}

Json materials_json(const Target& target) {
  constexpr int steps = 170;  // to 85 deg
  const std::vector<double> theta_i{0.0, 30.0, 60.0}, theta_r = half_degrees(steps);
  std::vector<std::size_t> facets(target.materials.size(), 0);
  const auto& back = target.back_material();
  for (std::size_t f = 0; f < target.mesh.size(); ++f) {
    ++facets[target.material[f]];
    if (back[f] != target.material[f]) ++facets[back[f]];
  }
  Json materials = Json::array();
  for (std::size_t m = 0; m < target.materials.size(); ++m) {
    Json curves = Json::array();
    for (const double theta : theta_i) curves.push_back(curve_json(target.materials[m].brdf, theta, theta_r));
    materials.push_back({{"name", readable(target.materials[m].name)},
                         {"definition", material_to_yaml(target.materials[m])},
                         {"facets", facets[m]},
                         {"theta_i_deg", theta_i},
                         {"theta_r_deg", theta_r},
                         {"f_r_per_sr", curves}});
  }
  return materials;
}

Json rows_json(const std::vector<SweepRow>& rows) {
  Json json{{"transmitter_azimuth_deg", Json::array()},
            {"transmitter_elevation_deg", Json::array()},
            {"receiver_azimuth_deg", Json::array()},
            {"receiver_elevation_deg", Json::array()},
            {"sigma_m2", Json::array()},
            {"bound_m2", Json::array()},
            {"seen_area_m2", Json::array()}};
  for (const SweepRow& row : rows) {
    json["transmitter_azimuth_deg"].push_back(row.aspect.transmitter.azimuth_deg);
    json["transmitter_elevation_deg"].push_back(row.aspect.transmitter.elevation_deg);
    json["receiver_azimuth_deg"].push_back(row.aspect.receiver.azimuth_deg);
    json["receiver_elevation_deg"].push_back(row.aspect.receiver.elevation_deg);
    json["sigma_m2"].push_back(row.sigma.value);
    json["bound_m2"].push_back(row.sigma.bound);
    json["seen_area_m2"].push_back(row.seen_area);
  }
  return json;
}

Json cuts_json(const Cuts& cuts) {
  Json json = Json::array();
  for (const ViewedCut& cut : cuts.cuts)
    json.push_back({{"label", cut.curve.label}, {"rows", cut.rows}, {"angle_deg", cut.curve.angle_deg}});
  return json;
}

std::string axis_of(CutAngle angle) {
  if (angle == CutAngle::azimuth) return "azimuth";
  return angle == CutAngle::elevation ? "elevation" : "row";
}

template <class T>
void append(std::vector<std::uint8_t>& bytes, const T& value) {
  const std::size_t at = bytes.size();
  bytes.resize(at + sizeof(T));
  std::memcpy(&bytes[at], &value, sizeof(T));
}

}  // namespace

std::string report_run_facts(const PastRun& run, const std::filesystem::path& manifest) try {
  return run_json(run, Json::parse(run.manifest)).dump(-1, ' ', true, Json::error_handler_t::replace);
} catch (const nlohmann::json::exception&) {
  throw InputError(Place{manifest.string()}, "expected the manifest of a sweep by this version; run the sweep again");
}

std::string report_json(const PastRun& run, const std::string& run_facts,
                        const std::vector<std::vector<double>>& part_sigma, const ShownTarget& shown,
                        const ShownReturns& returns) {
  const Cuts cuts = cuts_of_all(run.rows);
  const Json json{{"format", 2},
                  {"title", title_of(run.scene)},
                  {"version", version},
                  {"run", Json::parse(run_facts)},
                  {"target", target_json(run, shown)},
                  {"parts", parts_json(run.loaded.target.mesh)},
                  {"materials", materials_json(run.loaded.target)},
                  {"rows", rows_json(run.rows)},
                  {"axis", axis_of(cuts.angle)},
                  {"cuts", cuts_json(cuts)},
                  {"part_sigma_m2", part_sigma},
                  {"csv", run.csv},
                  {"shown",
                   {{"vertices", shown.positions.size()},
                    {"facets", shown.size()},
                    {"stored_rows", returns.rows()},
                    {"floor_db", ShownReturns::floor_db},
                    {"step_db", ShownReturns::step_db},
                    {"brightest_per_m2", returns.brightest()},
                    {"coding", "differences"}}}};
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

std::vector<std::uint8_t> report_facets(const PastRun& run, const ShownTarget& shown, const ShownReturns& returns) {
  const Target& target = run.loaded.target;
  std::vector<std::uint32_t> front(shown.size(), 0), back(shown.size(), 0);
  for (std::size_t k = 0; k < shown.shown_of.size(); ++k) {
    front[shown.shown_of[k]] = target.material[k];
    back[shown.shown_of[k]] = target.back_material()[k];
  }
  std::vector<std::uint8_t> bytes;
  for (const auto& p : shown.positions) append(bytes, p);
  for (const auto& t : shown.triangles) append(bytes, t);
  for (const double area : shown.area) append(bytes, static_cast<float>(area));
  for (const std::uint32_t part : shown.part) append(bytes, static_cast<std::uint16_t>(part));
  for (const auto& side : {front, back})
    for (const std::uint32_t material : side) append(bytes, static_cast<std::uint16_t>(material));
  for (const auto& values : {returns.levels(), returns.seen()}) bytes.insert(bytes.end(), values.begin(), values.end());
  return bytes;
}

}  // namespace lrcs
