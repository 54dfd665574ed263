#include "mesh/repair.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "base/splitmix64.h"
#include "mesh/closed_shells.h"
#include "mesh/collinear.h"
#include "mesh/index_table.h"
#include "mesh/weld.h"

namespace lrcs {
namespace {

using Corners = std::array<std::uint32_t, 3>;

std::size_t weld(FacetMesh& mesh) {
  const std::vector<std::uint32_t> place = keep_different(mesh.positions);
  for (Corners& corners : mesh.facets) {
    for (std::uint32_t& corner : corners) corner = place[corner];
  }
  return place.size() - mesh.positions.size();
}

// Drops the facets of which `drop` is true, and says how many they were.
std::size_t drop_facets(FacetMesh& mesh, const std::function<bool(std::size_t)>& drop) {
  std::vector lists{&mesh.part.of,  &mesh.file_material.of, &mesh.colour.of,
                    &mesh.layer.of, &mesh.source_facet,     &mesh.curved.of};
  for (FacetProperty& property : mesh.properties) lists.push_back(&property.values.of);
  std::size_t kept = 0;
  for (std::size_t k = 0; k < mesh.size(); ++k) {
    if (drop(k)) continue;
    mesh.facets[kept] = mesh.facets[k];
    for (auto* list : lists)
      if (!list->empty()) (*list)[kept] = (*list)[k];
    ++kept;
  }
  const std::size_t dropped = mesh.size() - kept;
  mesh.facets.resize(kept);
  for (auto* list : lists)
    if (!list->empty()) list->resize(kept);
  return dropped;
}

// The same for the same corners in the same winding.
Corners smallest_first(Corners corners) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

bool has_equal_corners(const Corners& c) {
  return c[0] == c[1] || c[1] == c[2] || c[2] == c[0];
}

bool is_degenerate(const FacetMesh& mesh, std::size_t facet) {
  const auto [a, b, c] = mesh.corners(facet);
  return are_collinear(a, b, c);
}

// Of every facet: does it repeat an earlier one, of the same part or of any?
std::vector<bool> repeated_facets(const FacetMesh& mesh, bool of_same_part) {
  std::vector<bool> repeated(mesh.size());
  IndexTable known(mesh.size());
  for (std::uint32_t k = 0; k < mesh.size(); ++k) {
    const Corners corners = smallest_first(mesh.facets[k]);
    const auto is_same = [&](std::uint32_t other) {
      return smallest_first(mesh.facets[other]) == corners && (!of_same_part || mesh.part.of[other] == mesh.part.of[k]);
    };
    std::uint64_t hash = of_same_part ? mesh.part.of[k] : 0;
    for (const std::uint32_t corner : corners) hash = splitmix64(hash ^ corner);
    repeated[k] = known.first_equal(hash, k, is_same) != k;
  }
  return repeated;
}

// Drops the facets that repeat an earlier one, of the same part or of any.
void drop_duplicate(FacetMesh& mesh, bool of_same_part, RepairCounts& counts) {
  const std::vector<bool> repeated = repeated_facets(mesh, of_same_part);
  // A degenerate facet is counted as that already.
  for (std::size_t k = 0; k < mesh.size(); ++k) counts.duplicate += repeated[k] && !is_degenerate(mesh, k) ? 1 : 0;
  drop_facets(mesh, [&](std::size_t k) { return repeated[k]; });
}

std::size_t count_degenerate(const FacetMesh& mesh) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < mesh.size(); ++k) count += is_degenerate(mesh, k) ? 1 : 0;
  return count;
}

std::size_t face_outward(FacetMesh& mesh) {
  std::size_t flipped = 0;
  for (const ClosedShell& shell : closed_shells(mesh)) {
    for (const std::uint32_t facet : shell.reversed) {
      std::swap(mesh.facets[facet][1], mesh.facets[facet][2]);
      if (!mesh.curved.of.empty() && mesh.curved.of[facet] != CurvedFacets::flat)
        turn_over(mesh.curved.patches[mesh.curved.of[facet]]);
      flipped += is_degenerate(mesh, facet) ? 0 : 1;
    }
  }
  return flipped;
}

RepairCounts connect(FacetMesh& mesh) {
  RepairCounts counts;
  counts.welded_vertices = weld(mesh);
  counts.degenerate = count_degenerate(mesh);
  drop_facets(mesh, [&](std::size_t k) { return has_equal_corners(mesh.facets[k]); });
  drop_duplicate(mesh, true, counts);
  counts.flipped = face_outward(mesh);
  // Where two parts touch, a side of the one repeats a side of the other as long as one of them faces inward.
  if (counts.flipped > 0 || mesh.part.names.size() > 1) drop_duplicate(mesh, false, counts);
  return counts;
}

}  // namespace

RepairCounts repair_connectivity(FacetMesh& mesh) {
  const RepairCounts counts = connect(mesh);
  measure_facets(mesh);
  return counts;
}

std::size_t drop_degenerate(FacetMesh& mesh) {
  const std::size_t dropped = drop_facets(mesh, [&](std::size_t k) { return is_degenerate(mesh, k); });
  measure_facets(mesh);
  return dropped;
}

RepairCounts repair(FacetMesh& mesh) {
  const RepairCounts counts = connect(mesh);
  drop_degenerate(mesh);
  return counts;
}

}  // namespace lrcs
