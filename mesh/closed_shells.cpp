#include "mesh/closed_shells.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "base/compensated_sum.h"
#include "base/large_pages.h"
#include "mesh/enclosure.h"
#include "mesh/facet_lists.h"
#include "mesh/winding_sets.h"

namespace lrcs {
namespace {

using Indices = std::vector<std::uint32_t>;

// Tears every set whose windings do not cancel at one of its edges.
void tear_open_sets(const Edges& edges, WindingSets& sets) {
  std::vector<std::pair<std::uint32_t, int>> steps;  // of the sets at an edge
  const auto step = [&](const EdgeUse& use) { return use.rising != sets.is_opposite(use.facet) ? 1 : -1; };
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    const auto uses = edges.uses(edge);
    // Nearly all are such edges.
    if (uses.size() == 2 && sets.root(uses[0].facet) == sets.root(uses[1].facet)) {
      if (step(uses[0]) == step(uses[1])) sets.tear(uses[0].facet);
      continue;
    }
    steps.clear();
    for (const EdgeUse& use : uses) steps.emplace_back(sets.root(use.facet), step(use));
    std::sort(steps.begin(), steps.end());
    for (std::size_t k = 0; k < steps.size();) {
      const std::uint32_t root = steps[k].first;
      int balance = 0;
      for (; k < steps.size() && steps[k].first == root; ++k) balance += steps[k].second;
      if (balance != 0) sets.tear(root);
    }
  }
}

// Six times the signed volume between the facet and the origin.
double wedge(const FacetMesh& mesh, std::uint32_t facet, const Vec3& origin) {
  const auto [a, b, c] = mesh.corners(facet);
  return (a - origin).dot((b - origin).cross(c - origin));
}

// Makes the shell's windings consistent, most of them as they are, and measures its volume.
ClosedShell shell_of(const FacetMesh& mesh, Indices facets, WindingSets& sets) {
  ClosedShell shell;
  shell.facets = std::move(facets);
  Indices same;
  for (const std::uint32_t facet : shell.facets) (sets.is_opposite(facet) ? shell.reversed : same).push_back(facet);
  if (same.size() < shell.reversed.size()) std::swap(same, shell.reversed);
  const Vec3& origin = mesh.positions[mesh.facets[shell.facets[0]][0]];
  CompensatedSum six_volumes;
  for (const std::uint32_t facet : same) six_volumes.add(wedge(mesh, facet, origin));
  for (const std::uint32_t facet : shell.reversed) six_volumes.add(-wedge(mesh, facet, origin));
  shell.volume = six_volumes.value() / 6.0;
  return shell;
}

void reverse(ClosedShell& shell) {
  Indices others;
  std::set_difference(shell.facets.begin(), shell.facets.end(), shell.reversed.begin(), shell.reversed.end(),
                      std::back_inserter(others));
  shell.reversed = std::move(others);
  shell.volume = -shell.volume;
}

void join_at_manifold_edges(const Edges& edges, WindingSets& sets) {
  sets.join_at_manifold_edges(edges);
}

// Connects facets across all edges, with the windings that they have.
void join_as_given(const Edges& edges, WindingSets& sets) {
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    for (const EdgeUse& use : edges.uses(edge)) sets.join(edges.uses(edge)[0].facet, use.facet, false);
  }
}

using Join = void (*)(const Edges&, WindingSets&);

// The closed shells among some facets, whose edges are given; what belongs to none is left in `facets`.
void take_shells(const FacetMesh& mesh, const Edges& edges, Join join, Indices& facets, bool in_one_part,
                 std::vector<ClosedShell>& shells) {
  WindingSets sets(mesh.size());
  join(edges, sets);
  tear_open_sets(edges, sets);
  std::map<std::uint32_t, Indices> closed;  // by the smallest facet, so that the order does not hang on the roots
  std::map<std::uint32_t, std::uint32_t> smallest;
  std::map<std::uint32_t, std::size_t> sizes;  // by the root
  for (const std::uint32_t facet : facets)
    if (!sets.is_torn(facet)) ++sizes[sets.root(facet)];
  Indices left;
  for (const std::uint32_t facet : facets) {
    if (sets.is_torn(facet)) {
      left.push_back(facet);
      continue;
    }
    const std::uint32_t root = sets.root(facet);
    const auto [first, is_new] = smallest.try_emplace(root, facet);
    Indices& members = closed[first->second];
    if (is_new) reserve_large(members, sizes[root]);
    members.push_back(facet);
  }
  for (auto& [first, members] : closed) {
    shells.push_back(shell_of(mesh, std::move(members), sets));
    shells.back().in_one_part = in_one_part;
  }
  facets = std::move(left);
}

void take_shells(const FacetMesh& mesh, Join join, Indices& facets, bool in_one_part,
                 std::vector<ClosedShell>& shells) {
  if (!facets.empty()) take_shells(mesh, Edges(mesh, facets), join, facets, in_one_part, shells);
}

// Below this, a volume is rounding.
double volume_noise(const FacetMesh& mesh, const ClosedShell& shell) {
  const Vec3& origin = mesh.positions[mesh.facets[shell.facets[0]][0]];
  double sum = 0.0;
  for (const std::uint32_t facet : shell.facets) {
    const auto [a, b, c] = mesh.corners(facet);
    sum += (a - origin).norm() * (b - origin).norm() * (c - origin).norm();
  }
  return 16.0 * std::numeric_limits<double>::epsilon() * sum;
}

void face_outward(const FacetMesh& mesh, std::vector<ClosedShell>& shells) {
  std::vector<std::size_t> inward;
  for (std::size_t k = 0; k < shells.size(); ++k) {
    if (shells[k].volume < 0.0 && shells[k].volume < -volume_noise(mesh, shells[k])) inward.push_back(k);
  }
  if (inward.empty()) return;
  Enclosure enclosure(mesh, shells);
  std::erase_if(inward, [&](std::size_t k) { return enclosure.is_inside_another(k); });
  for (const std::size_t k : inward) reverse(shells[k]);
}

}  // namespace

std::vector<ClosedShell> closed_shells(const FacetMesh& welded) {
  return closed_shells(welded, Edges(welded));
}

std::vector<ClosedShell> closed_shells(const FacetMesh& welded, const Edges& edges) {
  std::vector<ClosedShell> shells;
  Indices left;
  for (Indices& part : facets_of_parts(welded)) {
    if (part.size() == welded.size())
      take_shells(welded, edges, join_at_manifold_edges, part, true, shells);
    else
      take_shells(welded, join_at_manifold_edges, part, true, shells);
    take_shells(welded, join_as_given, part, true, shells);
    left.insert(left.end(), part.begin(), part.end());
  }
  std::sort(left.begin(), left.end());
  for (const Join join : {join_at_manifold_edges, join_as_given}) take_shells(welded, join, left, false, shells);
  face_outward(welded, shells);
  return shells;
}

}  // namespace lrcs
