#include "mesh/info_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace lrcs {
namespace {

using Json = nlohmann::ordered_json;

// Characters of UTF-8 text, for alignment.
std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string padded(std::string_view text, std::size_t width) {
  const std::size_t used = width_of(text);
  return std::string(text) + std::string(width > used ? width - used : 0, ' ');
}

std::string fact(std::string_view name, const std::string& value) {
  return padded(name, 22) + value + "\n";
}

std::string yes_no(bool value) {
  return value ? "yes" : "no";
}

std::string point_text(const Vec3& p) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z());
}

std::string size_text(const Diagnosis& d, std::string_view length) {
  const Vec3 size = d.box[1] - d.box[0];
  return fmt::format("{:.6g} x {:.6g} x {:.6g} {}, {} to {}", size.x(), size.y(), size.z(), length,
                     point_text(d.box[0]), point_text(d.box[1]));
}

std::string self_intersections_text(const SelfIntersections& found) {
  return fmt::format("{}{} pairs of facets{}", found.complete ? "" : "at least ", found.pairs,
                     found.complete ? "" : " (counting stopped)");
}

// "" is a part that the file gives no name.
std::string shown_name(const std::string& name) {
  return name.empty() ? "(no name)" : name;
}

std::string parts_table(const Diagnosis& d, std::string_view length) {
  std::size_t width = 4;
  for (const PartDiagnosis& part : d.parts) width = std::max(width, width_of(shown_name(part.name)));
  std::string table = fmt::format("\n{}  {:>9}  {:>14}  {:>14}  closed  material\n", padded("part", width), "facets",
                                  fmt::format("area [{}^2]", length), fmt::format("volume [{}^3]", length));
  for (const PartDiagnosis& part : d.parts)
    table += fmt::format("{}  {:>9}  {:>14.6g}  {:>14}  {:<6}  {}\n", padded(shown_name(part.name), width), part.facets,
                         part.area, part.volume ? fmt::format("{:.6g}", *part.volume) : "-", yes_no(part.closed),
                         part.file_material.empty() ? "-" : part.file_material);
  return table;
}

Json known(bool is_known, const Json& value) {
  return is_known ? value : Json(nullptr);
}

Json text_or_null(std::string_view text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

Json part_json(const PartDiagnosis& part, bool metres) {
  return {{"name", part.name},
          {"facets", part.facets},
          {"area_m2", known(metres, part.area)},
          {"volume_m3", known(metres && part.volume, part.volume.value_or(0.0))},
          {"closed", part.closed},
          {"material", text_or_null(part.file_material)},
          {"colour", nullptr}};
}

Json box_json(const Diagnosis& d) {
  Json box = Json::array();
  for (const Vec3& p : d.box) box.push_back(Json::array({p.x(), p.y(), p.z()}));
  return box;
}

}  // namespace

std::string info_text(const Diagnosis& d, std::string_view file, std::string_view unit) {
  const std::string length = unit.empty() ? "unit" : "m";
  return std::string(file) + "\n" +
         fact("unit", unit.empty() ? "not known: lengths are in the file's unit" : std::string(unit)) +
         fact("parts", fmt::format("{}", d.parts.size())) + fact("facets", fmt::format("{}", d.facets)) +
         fact("vertices", fmt::format("{}", d.vertices)) + fact("area", fmt::format("{:.6g} {}^2", d.area, length)) +
         fact("volume", fmt::format("{:.6g} {}^3 (closed shells)", d.volume, length)) +
         fact("box", size_text(d, length)) + fact("closed", yes_no(d.closed)) +
         fact("degenerate", fmt::format("{} facets", d.degenerate)) +
         fact("duplicate", fmt::format("{} facets", d.duplicate)) +
         fact("non-manifold", fmt::format("{} edges", d.non_manifold_edges)) +
         fact("boundary", fmt::format("{} edges", d.boundary_edges)) +
         fact("flipped", fmt::format("{} facets of closed shells", d.flipped)) +
         fact("self-intersecting", self_intersections_text(d.self_intersections)) + parts_table(d, length);
}

std::string info_json(const Diagnosis& d, std::string_view unit) {
  const bool metres = !unit.empty();
  Json parts = Json::array();
  for (const PartDiagnosis& part : d.parts) parts.push_back(part_json(part, metres));
  const Json json = {{"facets", d.facets},
                     {"vertices", d.vertices},
                     {"area_m2", known(metres, d.area)},
                     {"volume_m3", known(metres, d.volume)},
                     {"box_m", known(metres, box_json(d))},
                     {"closed", d.closed},
                     {"unit", text_or_null(unit)},
                     {"diagnosis",
                      {{"degenerate", d.degenerate},
                       {"duplicate", d.duplicate},
                       {"non_manifold_edges", d.non_manifold_edges},
                       {"boundary_edges", d.boundary_edges},
                       {"flipped", d.flipped},
                       {"self_intersections", d.self_intersections.pairs},
                       {"self_intersections_complete", d.self_intersections.complete}}},
                     {"parts", parts}};
  // Names in files need not be UTF-8: what is not becomes U+FFFD rather than an exception.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lrcs
