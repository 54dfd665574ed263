#include "mesh/diagnosis.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>

#include "base/compensated_sum.h"
#include "mesh/closed_shells.h"
#include "mesh/edges.h"
#include "mesh/gaps.h"
#include "mesh/holes.h"
#include "mesh/repair.h"
#include "mesh/weld.h"
#include "mesh/windings.h"

namespace lrcs {
namespace {

double area_of(const FacetMesh& mesh, std::size_t facet) {
  const auto [a, b, c] = mesh.corners(facet);
  return 0.5 * facet_cross(a, b, c).stableNorm() * mesh.metres_per_unit * mesh.metres_per_unit;
}

void count_vertices(const FacetMesh& mesh, Diagnosis& d) {
  const std::vector<std::uint32_t> first = first_equal(mesh.positions);
  std::vector<bool> used(first.size(), false);
  Eigen::AlignedBox3d box;
  for (const auto& facet : mesh.facets) {
    for (const std::uint32_t corner : facet) {
      used[first[corner]] = true;
      box.extend(mesh.positions[corner]);
    }
  }
  d.vertices = static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
  if (mesh.size() > 0) d.box = {mesh.metres_per_unit * box.min(), mesh.metres_per_unit * box.max()};
}

// The names of each part's facets, joined.
std::vector<std::string> names_by_part(const FacetMesh& mesh, const FacetNames& told) {
  std::vector<std::set<std::string>> names(mesh.part.names.size());
  if (!told.of.empty())
    for (std::size_t k = 0; k < mesh.size(); ++k) names[mesh.part.of[k]].insert(told.names[told.of[k]]);
  std::vector<std::string> joined(names.size());
  for (std::size_t p = 0; p < names.size(); ++p)
    for (const std::string& name : names[p])
      if (!name.empty()) joined[p] += (joined[p].empty() ? "" : ", ") + name;
  return joined;
}

std::vector<NamedFacets> facets_by(const FacetMesh& mesh, const FacetNames& told) {
  std::vector<NamedFacets> sums(told.names.size());
  std::vector<CompensatedSum> areas(told.names.size());
  for (std::size_t k = 0; k < told.of.size(); ++k) {
    ++sums[told.of[k]].facets;
    areas[told.of[k]].add(area_of(mesh, k));
  }
  for (std::size_t n = 0; n < sums.size(); ++n) {
    sums[n].name = told.names[n];
    sums[n].area = areas[n].value();
  }
  std::erase_if(sums, [](const NamedFacets& named) { return named.name.empty() || named.facets == 0; });
  return sums;
}

void measure_parts(const FacetMesh& mesh, Diagnosis& d) {
  const std::size_t count = mesh.part.names.size();
  std::vector<CompensatedSum> areas(count);
  CompensatedSum area;
  d.parts.resize(count);
  for (std::size_t k = 0; k < mesh.size(); ++k) {
    const std::uint32_t part = mesh.part.of[k];
    area.add(area_of(mesh, k));
    areas[part].add(area_of(mesh, k));
    ++d.parts[part].facets;
  }
  d.area = area.value();
  const auto materials = names_by_part(mesh, mesh.file_material), colours = names_by_part(mesh, mesh.colour),
             layers = names_by_part(mesh, mesh.layer);
  for (std::size_t p = 0; p < count; ++p) {
    d.parts[p].name = mesh.part.names[p];
    d.parts[p].area = areas[p].value();
    d.parts[p].file_material = materials[p];
    d.parts[p].colour = colours[p];
    d.parts[p].layer = layers[p];
  }
}

bool is_closed(const Edges& edges) {
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    if (edges.uses(edge).size() % 2 != 0) return false;
  }
  return edges.size() > 0;
}

// Adds one to a defect of the whole and of a part.
void count(Diagnosis& d, std::size_t Defects::*what, std::uint32_t part) {
  ++(d.*what);
  ++(d.parts[part].*what);
}

// Edges that more than two facets use, of the whole and of each part by itself.
void count_non_manifold(const FacetMesh& repaired, std::span<const EdgeUse> uses, Diagnosis& d) {
  if (uses.size() <= 2) return;
  ++d.non_manifold_edges;
  std::map<std::uint32_t, std::size_t> by_part;
  for (const EdgeUse& use : uses) ++by_part[repaired.part.of[use.facet]];
  for (const auto& [part, used] : by_part) d.parts[part].non_manifold_edges += used > 2 ? 1 : 0;
}

void count_edges(const FacetMesh& repaired, Diagnosis& d) {
  const Edges edges(repaired);
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    const auto uses = edges.uses(edge);
    if (uses.size() == 1) count(d, &Defects::boundary_edges, repaired.part.of[uses[0].facet]);
    count_non_manifold(repaired, uses, d);
  }
  d.closed = is_closed(edges);
}

// What is told of the repairs that a mesh would get.
void count_repairs(const RepairsByPart& repairs, Diagnosis& d) {
  const auto copy = [](const RepairCounts& from, Defects& to) {
    to.degenerate = from.degenerate;
    to.duplicate = from.duplicate;
    to.flipped = from.flipped;
    to.inward_shells = from.inward_shells;
  };
  copy(repairs.all, d);
  for (std::size_t p = 0; p < d.parts.size(); ++p) copy(repairs.parts[p], d.parts[p]);
}

void count_windings(const FacetMesh& repaired, Diagnosis& d) {
  for (const std::uint32_t facet : opposite_facets(repaired)) count(d, &Defects::opposite, repaired.part.of[facet]);
  for (const std::uint32_t facet : facets_against_most(repaired))
    count(d, &Defects::against_most, repaired.part.of[facet]);
}

void count_gaps(const FacetMesh& repaired, Diagnosis& d) {
  if (d.boundary_edges == 0) return;
  for (const Hole& hole : holes(repaired)) count(d, &Defects::holes, repaired.part.of[hole.facet]);
  const double gap = usual_gap(repaired);
  const Gaps gaps = find_gaps(repaired, gap);
  d.gap = gap * repaired.metres_per_unit;
  d.near_vertices = gaps.near_vertices.size();
  d.gaps_complete = gaps.complete;
  for (const TJunction& t : gaps.t_junctions) count(d, &Defects::t_junctions, repaired.part.of[t.facet]);
}

void count_self_intersections(const FacetMesh& repaired, Diagnosis& d) {
  d.self_intersections = self_intersections(repaired);
  const auto& names = repaired.part.names;
  for (const auto& [parts, pairs] : d.self_intersections.between_parts)
    d.meeting.push_back({names[parts.first], names[parts.second], pairs});
  std::stable_sort(d.meeting.begin(), d.meeting.end(),
                   [](const PartsMeeting& a, const PartsMeeting& b) { return a.facet_pairs > b.facet_pairs; });
}

void measure_volumes(const FacetMesh& repaired, Diagnosis& d) {
  std::vector<std::size_t> left(d.parts.size(), 0);  // facets that are in no closed shell of the part
  for (const std::uint32_t part : repaired.part.of) ++left[part];
  const double cubic_metres = std::pow(repaired.metres_per_unit, 3);
  CompensatedSum volume;
  std::vector<CompensatedSum> volumes(d.parts.size());
  for (const ClosedShell& shell : closed_shells(repaired)) {
    volume.add(shell.volume);
    if (!shell.in_one_part) continue;
    const std::uint32_t part = repaired.part.of[shell.facets[0]];
    volumes[part].add(shell.volume);
    left[part] -= shell.facets.size();
  }
  d.volume = cubic_metres * volume.value();
  for (std::size_t p = 0; p < d.parts.size(); ++p) {
    d.parts[p].closed = left[p] == 0 && d.parts[p].area > 0.0;
    if (d.parts[p].closed) d.parts[p].volume = cubic_metres * volumes[p].value();
  }
}

}  // namespace

Diagnosis diagnose(const FacetMesh& mesh) {
  Diagnosis d;
  d.facets = mesh.size();
  count_vertices(mesh, d);
  measure_parts(mesh, d);
  d.colours = facets_by(mesh, mesh.colour);
  d.file_materials = facets_by(mesh, mesh.file_material);
  for (const FacetProperty& property : mesh.properties)
    d.properties.push_back(fmt::format("{} ({} values)", property.name, property.values.names.size()));
  FacetMesh repaired = mesh;
  count_repairs(repair_connectivity(repaired), d);
  d.normals_against = mesh.normals_against;
  count_edges(repaired, d);
  count_windings(repaired, d);
  count_gaps(repaired, d);
  measure_volumes(repaired, d);
  drop_degenerate(repaired);
  count_self_intersections(repaired, d);
  return d;
}

}  // namespace lrcs
