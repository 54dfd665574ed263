#include "mesh/holes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <unordered_map>
#include <utility>

#include "mesh/edges.h"
#include "mesh/facet_lists.h"

namespace lrcs {
namespace {

using Point3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

// An open edge as a facet in the hole would use it: against its own facet's winding.
struct RimEdge {
  std::uint32_t from, to, facet;
};

std::vector<RimEdge> rim_edges(const FacetMesh& mesh) {
  std::vector<RimEdge> rims;
  for (const EdgeUse& use : open_edges(mesh))
    rims.push_back(use.rising ? RimEdge{use.high, use.low, use.facet} : RimEdge{use.low, use.high, use.facet});
  std::stable_sort(rims.begin(), rims.end(), [](const RimEdge& a, const RimEdge& b) { return a.facet < b.facet; });
  return rims;
}

// Walks along rims, each edge once. Edges are followed as they are directed where that goes on, else backward: windings
// need not agree.
class RimWalk {
 public:
  explicit RimWalk(std::vector<RimEdge> edges) : edges_(std::move(edges)), used_(edges_.size(), false) {
    for (std::uint32_t k = 0; k < edges_.size(); ++k) {
      ends_.push_back({edges_[k].from, 0, k});
      ends_.push_back({edges_[k].to, 1, k});
    }
    std::sort(ends_.begin(), ends_.end());
  }

  std::vector<Hole> all() {
    for (std::uint32_t k = 0; k < edges_.size(); ++k)
      if (!used_[k]) walk_from(k);
    return std::move(holes_);
  }

 private:
  using End = std::array<std::uint32_t, 3>;  // vertex; 0: the edge leaves it, 1: it arrives; edge

  // The steps of a walk: the vertices, and the edge by which each was left.
  struct Step {
    std::uint32_t vertex, edge;
  };

  void walk_from(std::uint32_t edge) {
    std::uint32_t at = edges_[edge].from;
    for (std::uint32_t next = edge; next != edges_.size(); next = unused_at(at)) {
      used_[next] = true;
      place_on_path_.emplace(at, path_.size());
      path_.push_back({at, next});
      at = edges_[next].from == at ? edges_[next].to : edges_[next].from;
      if (const auto begin = place_on_path_.find(at); begin != place_on_path_.end()) take_hole(begin->second, true, at);
    }
    if (!path_.empty()) take_hole(0, false, at);
  }

  // Takes the path from a step on, which leads to vertex `at`, for a rim.
  void take_hole(std::size_t begin, bool is_loop, std::uint32_t at) {
    Hole hole;
    hole.is_loop = is_loop;
    hole.facet = edges_[path_[begin].edge].facet;
    for (std::size_t step = begin; step < path_.size(); ++step) {
      hole.rim.push_back(path_[step].vertex);
      place_on_path_.erase(path_[step].vertex);
    }
    if (!is_loop) hole.rim.push_back(at);
    path_.resize(begin);
    holes_.push_back(std::move(hole));
  }

  [[nodiscard]] std::uint32_t unused_at(std::uint32_t vertex) const {
    for (auto end = std::lower_bound(ends_.begin(), ends_.end(), End{vertex, 0, 0});
         end != ends_.end() && (*end)[0] == vertex; ++end)
      if (!used_[(*end)[2]]) return (*end)[2];
    return static_cast<std::uint32_t>(edges_.size());
  }

  std::vector<RimEdge> edges_;
  std::vector<bool> used_;
  std::vector<End> ends_;
  std::vector<Step> path_;
  std::unordered_map<std::uint32_t, std::size_t> place_on_path_;  // of a vertex that was left
  std::vector<Hole> holes_;
};

std::vector<std::array<std::uint32_t, 3>> filling_of(const FacetMesh& mesh, const Hole& hole) {
  std::vector<Point3> rim;
  for (const std::uint32_t vertex : hole.rim) {
    const Vec3& p = mesh.positions[vertex];
    rim.emplace_back(p.x(), p.y(), p.z());
  }
  std::vector<CGAL::Triple<int, int, int>> found;
  CGAL::Polygon_mesh_processing::triangulate_hole_polyline(rim, std::back_inserter(found));
  std::vector<std::array<std::uint32_t, 3>> facets;
  facets.reserve(found.size());
  for (const auto& t : found)
    facets.push_back({hole.rim[static_cast<std::size_t>(t.first)], hole.rim[static_cast<std::size_t>(t.second)],
                      hole.rim[static_cast<std::size_t>(t.third)]});
  return facets;
}

}  // namespace

std::vector<Hole> holes(const FacetMesh& welded) {
  return RimWalk(rim_edges(welded)).all();
}

std::size_t fill_holes(FacetMesh& welded, std::size_t most_edges) {
  std::size_t filled = 0;
  for (const Hole& hole : holes(welded)) {
    if (!hole.is_loop || hole.rim.size() > most_edges) continue;
    const auto filling = filling_of(welded, hole);
    for (const auto& facet : filling) add_facet_like(welded, hole.facet, facet);
    filled += filling.empty() ? 0 : 1;
  }
  measure_facets(welded);
  return filled;
}

}  // namespace lrcs
