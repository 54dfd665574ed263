#include "mesh/repair.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "base/splitmix64.h"
#include "mesh/closed_shells.h"
#include "mesh/collinear.h"
#include "mesh/edges.h"
#include "mesh/facet_lists.h"
#include "mesh/index_table.h"
#include "mesh/weld.h"

namespace lrcs {
namespace {

using Corners = std::array<std::uint32_t, 3>;

std::size_t weld(FacetMesh& mesh) {
  const std::vector<std::uint32_t> place = keep_different(mesh.positions);
  if (place.size() == mesh.positions.size()) return 0;
  for (Corners& corners : mesh.facets) {
    for (std::uint32_t& corner : corners) corner = place[corner];
  }
  return place.size() - mesh.positions.size();
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

// Of every facet: is it degenerate?
std::vector<std::uint8_t> degenerate_facets(const FacetMesh& mesh) {
  std::vector<std::uint8_t> degenerate(mesh.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mesh.size(), 4096), [&](const auto& range) {
    for (std::size_t k = range.begin(); k < range.end(); ++k) degenerate[k] = is_degenerate(mesh, k) ? 1 : 0;
  });
  return degenerate;
}

// Could a facet repeat another? It would take all of its edges in the same direction.
bool may_repeat(const Edges& edges) {
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    std::size_t rising = 0;
    for (const EdgeUse& use : edges.uses(edge)) rising += use.rising ? 1 : 0;
    if (rising > 1 || edges.uses(edge).size() - rising > 1) return true;
  }
  return false;
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

// Adds one to a count of the whole and of a facet's part.
void count(RepairsByPart& repairs, std::size_t RepairCounts::*what, std::uint32_t part) {
  ++(repairs.all.*what);
  ++(repairs.parts[part].*what);
}

// Drops the facets that repeat an earlier one, of the same part or of any.
void drop_duplicate(FacetMesh& mesh, bool of_same_part, RepairsByPart& repairs) {
  const std::vector<bool> repeated = repeated_facets(mesh, of_same_part);
  // A degenerate facet is counted as that already.
  for (std::size_t k = 0; k < mesh.size(); ++k)
    if (repeated[k] && !is_degenerate(mesh, k)) count(repairs, &RepairCounts::duplicate, mesh.part.of[k]);
  drop_facets(mesh, [&](std::size_t k) { return repeated[k]; });
}

void count_degenerate(const FacetMesh& mesh, RepairsByPart& repairs) {
  const std::vector<std::uint8_t> degenerate = degenerate_facets(mesh);
  for (std::size_t k = 0; k < mesh.size(); ++k)
    if (degenerate[k] != 0) count(repairs, &RepairCounts::degenerate, mesh.part.of[k]);
}

void face_outward(FacetMesh& mesh, const Edges& edges, RepairsByPart& repairs) {
  for (const ClosedShell& shell : closed_shells(mesh, edges)) {
    turn_over(mesh, shell.reversed);
    for (const std::uint32_t facet : shell.reversed)
      if (!is_degenerate(mesh, facet)) count(repairs, &RepairCounts::flipped, mesh.part.of[facet]);
    if (2 * shell.reversed.size() <= shell.facets.size()) continue;
    ++repairs.all.inward_shells;
    if (shell.in_one_part) ++repairs.parts[mesh.part.of[shell.facets[0]]].inward_shells;
  }
}

RepairsByPart connect(FacetMesh& mesh) {
  RepairsByPart repairs;
  repairs.parts.resize(mesh.part.names.size());
  repairs.all.welded_vertices = weld(mesh);
  count_degenerate(mesh, repairs);
  drop_facets(mesh, [&](std::size_t k) { return has_equal_corners(mesh.facets[k]); });
  std::optional<Edges> edges(mesh);
  if (may_repeat(*edges)) {
    drop_duplicate(mesh, true, repairs);
    edges.emplace(mesh);
  }
  face_outward(mesh, *edges, repairs);
  // Where two parts touch, a side of the one repeats a side of the other as long as one of them faces inward.
  if (repairs.all.flipped > 0 || mesh.part.names.size() > 1) drop_duplicate(mesh, false, repairs);
  return repairs;
}

}  // namespace

RepairsByPart repair_connectivity(FacetMesh& mesh) {
  RepairsByPart repairs = connect(mesh);
  measure_facets(mesh);
  return repairs;
}

std::vector<std::uint32_t> opposite_facets(const FacetMesh& mesh) {
  const auto sorted = [&](std::uint32_t facet) {
    Corners corners = mesh.facets[facet];
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  std::vector<std::uint32_t> opposite;
  IndexTable known(mesh.size());
  for (std::uint32_t k = 0; k < mesh.size(); ++k) {
    const Corners corners = sorted(k);
    std::uint64_t hash = 0;
    for (const std::uint32_t corner : corners) hash = splitmix64(hash ^ corner);
    // No two have the same winding.
    if (known.first_equal(hash, k, [&](std::uint32_t other) { return sorted(other) == corners; }) != k)
      opposite.push_back(k);
  }
  return opposite;
}

std::size_t drop_degenerate(FacetMesh& mesh) {
  const std::size_t dropped = drop_facets(mesh, [&](std::size_t k) { return is_degenerate(mesh, k); });
  measure_facets(mesh);
  return dropped;
}

RepairCounts repair(FacetMesh& mesh) {
  const RepairsByPart repairs = connect(mesh);
  if (repairs.all.degenerate > 0)
    drop_degenerate(mesh);
  else
    measure_facets(mesh);
  return repairs.all;
}

}  // namespace lrcs
