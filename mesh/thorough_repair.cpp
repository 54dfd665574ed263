#include "mesh/thorough_repair.h"

#include <algorithm>

#include "mesh/facet_lists.h"
#include "mesh/gaps.h"
#include "mesh/holes.h"
#include "mesh/windings.h"

namespace lrcs {
namespace {

void add(ThoroughCounts& sum, const RepairCounts& more) {
  sum.welded_vertices += more.welded_vertices;
  sum.degenerate += more.degenerate;
  sum.duplicate += more.duplicate;
  sum.flipped += more.flipped;
  sum.inward_shells += more.inward_shells;
}

void repair_again(FacetMesh& mesh, ThoroughRepairs& repairs) {
  const RepairsByPart more = repair_connectivity(mesh);
  drop_degenerate(mesh);
  add(repairs.all, more.all);
  for (std::size_t p = 0; p < repairs.parts.size(); ++p) add(repairs.parts[p], more.parts[p]);
}

void count(const FacetMesh& mesh, const std::vector<std::uint32_t>& facets, std::size_t ThoroughCounts::*what,
           ThoroughRepairs& repairs) {
  repairs.all.*what += facets.size();
  for (const std::uint32_t facet : facets) ++(repairs.parts[mesh.part.of[facet]].*what);
}

void close_gaps(FacetMesh& mesh, double tolerance, ThoroughRepairs& repairs) {
  const GapCounts gaps = close_gaps(mesh, tolerance);
  repairs.all.near_vertices = gaps.welded;
  repairs.all.t_junctions = gaps.t_junctions;
  repairs.all.complete = gaps.complete;
}

void drop_opposite(FacetMesh& mesh, ThoroughRepairs& repairs) {
  const auto opposite = opposite_facets(mesh);
  count(mesh, opposite, &ThoroughCounts::opposite, repairs);
  drop_facets(mesh, [&](std::size_t k) { return std::binary_search(opposite.begin(), opposite.end(), k); });
}

void turn_to_most(FacetMesh& mesh, ThoroughRepairs& repairs) {
  const auto against = facets_against_most(mesh);
  count(mesh, against, &ThoroughCounts::flipped, repairs);
  turn_over(mesh, against);
}

}  // namespace

ThoroughRepairs repair_thoroughly(FacetMesh& mesh, const RepairWishes& wishes) {
  ThoroughRepairs repairs;
  repairs.parts.resize(mesh.part.names.size());
  repair_again(mesh, repairs);
  close_gaps(mesh, wishes.tolerance, repairs);
  if (wishes.drop_opposite) drop_opposite(mesh, repairs);
  turn_to_most(mesh, repairs);
  if (wishes.most_hole_edges > 0) repairs.all.holes_filled = fill_holes(mesh, wishes.most_hole_edges);
  repair_again(mesh, repairs);
  return repairs;
}

}  // namespace lrcs
