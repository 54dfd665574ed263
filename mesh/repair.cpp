#include "mesh/repair.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "mesh/closed_shells.h"
#include "mesh/facet_lists.h"
#include "mesh/weld.h"

namespace lrcs {
namespace {

using Corners = std::array<std::uint32_t, 3>;

std::size_t weld(FacetMesh& mesh) {
  std::vector<std::uint32_t> place = first_equal(mesh.positions);
  std::uint32_t kept = 0;
  for (std::size_t k = 0; k < place.size(); ++k) {
    if (place[k] == k) {
      mesh.positions[kept] = mesh.positions[k];
      place[k] = kept++;
    } else {
      place[k] = place[place[k]];
    }
  }
  for (Corners& corners : mesh.facets) {
    for (std::uint32_t& corner : corners) corner = place[corner];
  }
  const std::size_t welded = mesh.positions.size() - kept;
  mesh.positions.resize(kept);
  return welded;
}

// The same for the same corners in the same winding.
Corners smallest_first(Corners corners) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

struct KeyHash {
  std::size_t operator()(const std::pair<Corners, std::uint32_t>& key) const {
    std::uint64_t hash = key.second;
    for (const std::uint32_t corner : key.first) hash = (hash ^ corner) * 0x9e3779b97f4a7c15U;
    return hash ^ hash >> 32U;
  }
};

bool has_equal_corners(const Corners& c) {
  return c[0] == c[1] || c[1] == c[2] || c[2] == c[0];
}

bool is_degenerate(const FacetMesh& mesh, std::size_t facet) {
  const auto [a, b, c] = mesh.corners(facet);
  return facet_cross(a, b, c).isZero(0.0);
}

// Adds one to a count of the whole and of a facet's part.
void count(RepairsByPart& repairs, std::size_t RepairCounts::*what, std::uint32_t part) {
  ++(repairs.all.*what);
  ++(repairs.parts[part].*what);
}

// Drops the facets that repeat an earlier one, of the same part or of any.
void drop_duplicate(FacetMesh& mesh, bool of_same_part, RepairsByPart& repairs) {
  std::unordered_set<std::pair<Corners, std::uint32_t>, KeyHash> known;
  known.reserve(mesh.size());
  drop_facets(mesh, [&](std::size_t k) {
    if (known.emplace(smallest_first(mesh.facets[k]), of_same_part ? mesh.part.of[k] : 0U).second) return false;
    // A degenerate facet is counted as that already.
    if (!is_degenerate(mesh, k)) count(repairs, &RepairCounts::duplicate, mesh.part.of[k]);
    return true;
  });
}

void count_degenerate(const FacetMesh& mesh, RepairsByPart& repairs) {
  for (std::size_t k = 0; k < mesh.size(); ++k)
    if (is_degenerate(mesh, k)) count(repairs, &RepairCounts::degenerate, mesh.part.of[k]);
}

void face_outward(FacetMesh& mesh, RepairsByPart& repairs) {
  for (const ClosedShell& shell : closed_shells(mesh)) {
    turn_over(mesh, shell.reversed);
    for (const std::uint32_t facet : shell.reversed)
      if (!is_degenerate(mesh, facet)) count(repairs, &RepairCounts::flipped, mesh.part.of[facet]);
    if (2 * shell.reversed.size() <= shell.facets.size()) continue;
    ++repairs.all.inward_shells;
    if (shell.in_one_part) ++repairs.parts[mesh.part.of[shell.facets[0]]].inward_shells;
  }
}

}  // namespace

RepairsByPart repair_connectivity(FacetMesh& mesh) {
  RepairsByPart repairs;
  repairs.parts.resize(mesh.part.names.size());
  repairs.all.welded_vertices = weld(mesh);
  count_degenerate(mesh, repairs);
  drop_facets(mesh, [&](std::size_t k) { return has_equal_corners(mesh.facets[k]); });
  drop_duplicate(mesh, true, repairs);
  // Where two parts touch, a side of the one repeats a side of the other as long as one of them faces inward.
  face_outward(mesh, repairs);
  drop_duplicate(mesh, false, repairs);
  measure_facets(mesh);
  return repairs;
}

std::vector<std::uint32_t> opposite_facets(const FacetMesh& mesh) {
  std::unordered_set<std::pair<Corners, std::uint32_t>, KeyHash> known;
  known.reserve(mesh.size());
  std::vector<std::uint32_t> opposite;
  for (std::uint32_t k = 0; k < mesh.size(); ++k) {
    const auto& [a, b, c] = mesh.facets[k];
    if (known.contains({smallest_first({a, c, b}), 0U})) opposite.push_back(k);
    known.emplace(smallest_first(mesh.facets[k]), 0U);
  }
  return opposite;
}

std::size_t drop_degenerate(FacetMesh& mesh) {
  const std::size_t dropped = drop_facets(mesh, [&](std::size_t k) { return is_degenerate(mesh, k); });
  measure_facets(mesh);
  return dropped;
}

RepairCounts repair(FacetMesh& mesh) {
  const RepairsByPart repairs = repair_connectivity(mesh);
  drop_degenerate(mesh);
  return repairs.all;
}

}  // namespace lrcs
