#include "mesh/info_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

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

std::string boundary_text(const Diagnosis& d, std::string_view length) {
  std::string text = fmt::format("{} edges", d.boundary_edges);
  if (d.boundary_edges == 0) return text;
  text += fmt::format(" round {} holes or sheets", d.holes);
  if (d.near_vertices + d.t_junctions > 0 || !d.gaps_complete)
    text += fmt::format("; gaps of at most {:.2g} {}: {}{} pairs of vertices, {} T-junctions", d.gap, length,
                        d.gaps_complete ? "" : "at least ", d.near_vertices, d.t_junctions);
  return text;
}

std::string normals_text(const Diagnosis& d) {
  return fmt::format("{} of {} point to the back of their facet's winding: the winding is used", d.normals_against,
                     d.facets);
}

// Shown at most, of what there may be many of.
constexpr std::size_t most_lines = 12;

std::string meeting_text(const std::vector<PartsMeeting>& meeting) {
  std::string text;
  for (std::size_t k = 0; k < std::min(meeting.size(), most_lines); ++k)
    text +=
        fact(k == 0 ? "parts that meet" : "", fmt::format("{} and {}: {} pairs of facets", shown_name(meeting[k].one),
                                                          shown_name(meeting[k].other), meeting[k].facet_pairs));
  if (meeting.size() > most_lines) text += fact("", fmt::format("and {} more", meeting.size() - most_lines));
  return text;
}

using NamedCount = std::pair<const char*, std::size_t>;

// By the keys of JSON.
std::vector<NamedCount> counts_of(const Defects& d) {
  return {{"degenerate", d.degenerate},         {"duplicate", d.duplicate},
          {"opposite_duplicate", d.opposite},   {"non_manifold_edges", d.non_manifold_edges},
          {"boundary_edges", d.boundary_edges}, {"holes", d.holes},
          {"t_junctions", d.t_junctions},       {"flipped", d.flipped},
          {"inward_shells", d.inward_shells},   {"against_most", d.against_most}};
}

std::string defects_text(const Defects& defects) {
  std::string text;
  for (const auto& [name, count] : counts_of(defects)) {
    if (count == 0) continue;
    std::string words = name;
    std::replace(words.begin(), words.end(), '_', ' ');
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, words);
  }
  return text;
}

// What is wrong with which part, where there are several.
std::string defects_table(const std::vector<PartDiagnosis>& parts) {
  if (parts.size() < 2) return "";
  std::string table;
  std::size_t shown = 0, more = 0;
  for (const PartDiagnosis& part : parts) {
    const std::string text = defects_text(part);
    if (text.empty()) continue;
    if (shown++ < 4 * most_lines)
      table += fmt::format("{}: {}\n", shown_name(part.name), text);
    else
      ++more;
  }
  if (more > 0) table += fmt::format("and {} parts more\n", more);
  return table.empty() ? "" : "\nwhat is wrong with parts\n" + table;
}

// A line of the tree: a part, or what holds parts.
struct TreeLine {
  std::string name;  // indented
  std::size_t facets = 0;
  double area = 0.0;
  const PartDiagnosis* part = nullptr;
};

// Parts in file order, each path through an assembly once.
std::vector<TreeLine> tree_of(const std::vector<PartDiagnosis>& parts) {
  constexpr std::size_t is_part = ~std::size_t{0};  // what holds others and is a part itself has its own sums
  std::vector<TreeLine> lines;
  std::map<std::string, std::size_t> known;
  for (const PartDiagnosis& part : parts) {
    std::size_t depth = 0, begin = 0;
    for (std::size_t slash = part.name.find('/'); slash != std::string::npos; slash = part.name.find('/', begin)) {
      const auto [line, is_new] = known.try_emplace(part.name.substr(0, slash), lines.size());
      if (is_new) lines.push_back({std::string(2 * depth, ' ') + part.name.substr(begin, slash - begin)});
      if (line->second != is_part) {
        lines[line->second].facets += part.facets;
        lines[line->second].area += part.area;
      }
      begin = slash + 1;
      ++depth;
    }
    known.try_emplace(part.name, is_part);
    lines.push_back({std::string(2 * depth, ' ') + shown_name(part.name.substr(begin)), part.facets, part.area, &part});
  }
  return lines;
}

std::string or_dash(const std::string& words) {
  return words.empty() ? "-" : words;
}

std::string parts_table(const Diagnosis& d, std::string_view length) {
  const auto lines = tree_of(d.parts);
  std::size_t width = 4, material_width = 8;
  bool coloured = false;
  for (const TreeLine& line : lines) width = std::max(width, width_of(line.name));
  for (const PartDiagnosis& part : d.parts) {
    material_width = std::max(material_width, width_of(part.file_material));
    coloured |= !part.colour.empty();
  }
  const auto last = [&](const std::string& material, const std::string& colour) {
    return coloured ? padded(material, material_width) + "  " + colour : material;
  };
  std::string table =
      fmt::format("\n{}  {:>9}  {:>14}  {:>14}  closed  {}\n", padded("part", width), "facets",
                  fmt::format("area [{}^2]", length), fmt::format("volume [{}^3]", length), last("material", "colour"));
  for (const TreeLine& line : lines) {
    const PartDiagnosis* part = line.part;
    table += fmt::format("{}  {:>9}  {:>14.6g}", padded(line.name, width), line.facets, line.area);
    if (part != nullptr)
      table += fmt::format("  {:>14}  {:<6}  {}", part->volume ? fmt::format("{:.6g}", *part->volume) : "-",
                           yes_no(part->closed), last(or_dash(part->file_material), or_dash(part->colour)));
    table += "\n";
  }
  return table;
}

// In YAML: between quotes, whatever it holds.
std::string quoted(const std::string& words) {
  std::string text = "\"";
  for (const char c : words) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + "\"";
}

// As a pattern: instances of one name are one, and letters that mean something there stand for themselves.
std::string pattern_of(const std::string& name, bool is_path) {
  std::string pattern;
  for (std::size_t k = 0; k < name.size(); ++k) {
    if (is_path && name[k] == ':') {
      const std::size_t end = std::min(name.find_first_not_of("0123456789", k + 1), name.size());
      if (end > k + 1 && (end == name.size() || name[end] == '/')) {
        pattern += ":*";
        k = end - 1;
        continue;
      }
    }
    if (name[k] == '*' || name[k] == '?' || name[k] == '[' || name[k] == '\\') pattern += '\\';
    pattern += name[k];
  }
  return pattern;
}

std::string rule(const char* key, const std::string& pattern, const std::string& comment) {
  return fmt::format("  - {{{}: {}, material: MATERIAL}}  # {}\n", key, quoted(pattern), comment);
}

// Scans have a colour a face.
constexpr std::size_t most_rules = 100;

std::string rules_by(const char* key, const std::vector<NamedFacets>& names) {
  std::string rules;
  for (const NamedFacets& n : std::span(names).first(std::min(most_rules, names.size())))
    rules += rule(key, pattern_of(n.name, false), fmt::format("{} facets, area {:.4g}", n.facets, n.area));
  if (names.size() > most_rules) rules += fmt::format("  # and {} more\n", names.size() - most_rules);
  return rules;
}

// Instances of one name share a rule.
std::string rules_by_part(const std::vector<PartDiagnosis>& parts) {
  std::vector<std::string> patterns;
  std::map<std::string, std::pair<std::size_t, double>> sums;
  for (const PartDiagnosis& part : parts) {
    if (part.name.empty()) continue;
    const std::string pattern = pattern_of(part.name, true);
    auto& [count, area] = sums[pattern];
    if (count++ == 0) patterns.push_back(pattern);
    area += part.area;
  }
  std::string rules;
  for (const std::string& pattern : patterns) {
    const auto& [count, area] = sums[pattern];
    rules += rule("part", pattern, fmt::format("{} part{}, area {:.4g}", count, count == 1 ? "" : "s", area));
  }
  return rules;
}

std::string assign_block(const Diagnosis& d) {
  std::string rules;
  if (d.file_materials.size() > 1 && d.file_materials.size() >= d.colours.size())
    rules = rules_by("file_material", d.file_materials);
  else if (d.colours.size() > 1)
    rules = rules_by("colour", d.colours);
  else if (d.parts.size() > 1)
    rules = rules_by_part(d.parts);
  return rules.empty() ? "" : "\nassign:  # for a scene file\n" + rules + "  - {default: MATERIAL}\n";
}

Json known(bool is_known, const Json& value) {
  return is_known ? value : Json(nullptr);
}

Json text_or_null(std::string_view text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

Json defects_json(const Defects& defects, bool with_zeros) {
  Json json = Json::object();
  for (const auto& [name, count] : counts_of(defects))
    if (with_zeros || count > 0) json[name] = count;
  return json;
}

Json part_json(const PartDiagnosis& part, bool metres) {
  Json json{{"name", part.name},
            {"facets", part.facets},
            {"area_m2", known(metres, part.area)},
            {"volume_m3", known(metres && part.volume, part.volume.value_or(0.0))},
            {"closed", part.closed},
            {"material", text_or_null(part.file_material)},
            {"colour", text_or_null(part.colour)}};
  if (!part.layer.empty()) json["layer"] = part.layer;
  if (Json defects = defects_json(part, false); !defects.empty()) json["diagnosis"] = std::move(defects);
  return json;
}

Json diagnosis_json(const Diagnosis& d) {
  Json json = defects_json(d, true);
  json["near_vertices"] = d.near_vertices;
  json["gaps_complete"] = d.gaps_complete;
  json["normals_against_winding"] = d.normals_against;
  json["self_intersections"] = d.self_intersections.pairs;
  json["self_intersections_complete"] = d.self_intersections.complete;
  Json meeting = Json::array();
  for (const PartsMeeting& m : d.meeting)
    meeting.push_back({{"parts", {m.one, m.other}}, {"facet_pairs", m.facet_pairs}});
  json["parts_that_meet"] = std::move(meeting);
  return json;
}

Json box_json(const Diagnosis& d) {
  Json box = Json::array();
  for (const Vec3& p : d.box) box.push_back(Json::array({p.x(), p.y(), p.z()}));
  return box;
}

}  // namespace

std::string shown_name(const std::string& name) {
  return name.empty() ? "(no name)" : name;
}

std::string info_text(const Diagnosis& d, const FileFacts& facts) {
  const std::string length = facts.unit.empty() ? "unit" : "m";
  std::string warnings;
  for (const std::string& warning : facts.warnings) warnings += fact("warning", warning);
  return facts.file + "\n" +
         fact("unit", facts.unit.empty() ? "not known: lengths are in the file's unit" : facts.unit) +
         (facts.tessellation.empty() ? "" : fact("tessellation", facts.tessellation)) + warnings +
         (d.properties.empty() ? "" : fact("facet properties", fmt::format("{}", fmt::join(d.properties, ", ")))) +
         fact("parts", fmt::format("{}", d.parts.size())) + fact("facets", fmt::format("{}", d.facets)) +
         fact("vertices", fmt::format("{}", d.vertices)) + fact("area", fmt::format("{:.6g} {}^2", d.area, length)) +
         fact("volume", fmt::format("{:.6g} {}^3 (closed shells)", d.volume, length)) +
         fact("box", size_text(d, length)) + fact("closed", yes_no(d.closed)) +
         fact("degenerate", fmt::format("{} facets", d.degenerate)) +
         fact("duplicate", fmt::format("{} facets, and {} in the opposite winding", d.duplicate, d.opposite)) +
         fact("non-manifold", fmt::format("{} edges", d.non_manifold_edges)) +
         fact("boundary", boundary_text(d, length)) +
         fact("flipped", fmt::format("{} facets of closed shells ({} shells face inward), {} of open pieces", d.flipped,
                                     d.inward_shells, d.against_most)) +
         (d.normals_against == 0 ? "" : fact("normals in the file", normals_text(d))) +
         fact("self-intersecting", self_intersections_text(d.self_intersections)) + meeting_text(d.meeting) +
         parts_table(d, length) + defects_table(d.parts) + assign_block(d);
}

std::string info_json(const Diagnosis& d, const FileFacts& facts) {
  const bool metres = !facts.unit.empty();
  Json parts = Json::array();
  for (const PartDiagnosis& part : d.parts) parts.push_back(part_json(part, metres));
  Json json = {{"facets", d.facets},
               {"vertices", d.vertices},
               {"area_m2", known(metres, d.area)},
               {"volume_m3", known(metres, d.volume)},
               {"box_m", known(metres, box_json(d))},
               {"closed", d.closed},
               {"unit", text_or_null(facts.unit)},
               {"diagnosis", diagnosis_json(d)},
               {"parts", parts}};
  if (!d.properties.empty()) json["properties"] = d.properties;
  if (!facts.tessellation.empty()) json["tessellation"] = facts.tessellation;
  if (!facts.warnings.empty()) json["warnings"] = facts.warnings;
  // Names in files need not be UTF-8: what is not becomes U+FFFD rather than an exception.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lrcs
