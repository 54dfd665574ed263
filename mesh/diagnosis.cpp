#include "mesh/diagnosis.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "base/compensated_sum.h"
#include "mesh/closed_shells.h"
#include "mesh/edges.h"
#include "mesh/repair.h"
#include "mesh/weld.h"

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

void count_edges(const FacetMesh& repaired, Diagnosis& d) {
  std::vector<std::uint32_t> all(repaired.size());
  std::iota(all.begin(), all.end(), 0U);
  const Edges edges(repaired, all);
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    d.boundary_edges += edges.uses(edge).size() == 1 ? 1 : 0;
    d.non_manifold_edges += edges.uses(edge).size() > 2 ? 1 : 0;
  }
  d.closed = is_closed(edges);
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
  const RepairCounts counts = repair_connectivity(repaired);
  d.degenerate = counts.degenerate;
  d.duplicate = counts.duplicate;
  d.flipped = counts.flipped;
  count_edges(repaired, d);
  measure_volumes(repaired, d);
  drop_degenerate(repaired);
  d.self_intersections = self_intersections(repaired);
  return d;
}

}  // namespace lrcs
