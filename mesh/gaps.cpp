#include "mesh/gaps.h"

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

#include "mesh/edges.h"
#include "mesh/facet_lists.h"
#include "mesh/repair.h"

namespace lrcs {
namespace {

using NumberedBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;

class GapSearch {
 public:
  GapSearch(const FacetMesh& mesh, double tolerance)
      : mesh_(mesh), tolerance_(tolerance), edges_(open_edges(mesh)), left_(10'000'000 + 20 * edges_.size()) {
    for (std::uint32_t k = 0; k < edges_.size(); ++k) {
      const auto [low, high, facet, rising] = edges_[k];
      edge_boxes_.push_back(box_around({low, high}, 0.5 * tolerance, k));
      for (const std::uint32_t vertex : {low, high}) vertices_.push_back(vertex);
    }
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    for (const std::uint32_t v : vertices_) vertex_boxes_.push_back(box_around({v, v}, 0.5 * tolerance, v));
  }

  Gaps run() {
    Gaps gaps;
    try {
      find_near_vertices(gaps);
      find_t_junctions(gaps);
    } catch (const Enough&) {
      gaps.complete = false;
    }
    // CGAL's order is fixed, but not that of the mesh.
    std::sort(gaps.near_vertices.begin(), gaps.near_vertices.end());
    std::sort(gaps.t_junctions.begin(), gaps.t_junctions.end(), [](const TJunction& a, const TJunction& b) {
      return std::tie(a.facet, a.edge, a.along, a.vertex) < std::tie(b.facet, b.edge, b.along, b.vertex);
    });
    return gaps;
  }

 private:
  struct Enough {};  // the only way to stop CGAL early

  // Rounded up by more than the sum rounds: no pair within the tolerance is missed.
  [[nodiscard]] NumberedBox box_around(const std::array<std::uint32_t, 2>& vertices, double margin,
                                       std::uint32_t info) const {
    CGAL::Bbox_3 box;
    for (const std::uint32_t vertex : vertices) {
      const Vec3& p = mesh_.positions[vertex];
      box +=
          CGAL::Bbox_3(p.x() - margin, p.y() - margin, p.z() - margin, p.x() + margin, p.y() + margin, p.z() + margin);
    }
    box.dilate(1);
    return {box, info};
  }

  void count_test() {
    if (left_-- == 0) throw Enough();
  }

  void find_near_vertices(Gaps& gaps) {
    if (tolerance_ <= 0.0) return;
    std::vector<NumberedBox> boxes = vertex_boxes_;
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const NumberedBox& a, const NumberedBox& b) {
      count_test();
      if (distance(a.info(), b.info()) <= tolerance_)
        gaps.near_vertices.emplace_back(std::min(a.info(), b.info()), std::max(a.info(), b.info()));
    });
  }

  void find_t_junctions(Gaps& gaps) {
    CGAL::box_intersection_d(edge_boxes_.begin(), edge_boxes_.end(), vertex_boxes_.begin(), vertex_boxes_.end(),
                             [&](const NumberedBox& edge, const NumberedBox& vertex) {
                               count_test();
                               test(edges_[edge.info()], vertex.info(), gaps);
                             });
  }

  void test(const EdgeUse& edge, std::uint32_t vertex, Gaps& gaps) const {
    const auto& corners = mesh_.facets[edge.facet];
    if (std::find(corners.begin(), corners.end(), vertex) != corners.end()) return;
    const std::uint32_t from = edge.rising ? edge.low : edge.high, to = edge.rising ? edge.high : edge.low;
    if (distance(from, vertex) <= tolerance_ || distance(to, vertex) <= tolerance_) return;
    const Vec3 &a = mesh_.positions[from], &b = mesh_.positions[to], &v = mesh_.positions[vertex];
    const double along = (v - a).dot(b - a) / (b - a).squaredNorm();
    if (along <= 0.0 || along >= 1.0) return;
    // Exactly zero for a vertex exactly on the edge's line.
    if (facet_cross(a, b, v).stableNorm() > tolerance_ * (b - a).stableNorm()) return;
    const auto* const corner = std::find(corners.begin(), corners.end(), from);
    gaps.t_junctions.push_back({edge.facet, static_cast<std::uint32_t>(corner - corners.begin()), vertex, along});
  }

  [[nodiscard]] double distance(std::uint32_t a, std::uint32_t b) const {
    return (mesh_.positions[a] - mesh_.positions[b]).stableNorm();
  }

  const FacetMesh& mesh_;
  double tolerance_;
  std::vector<EdgeUse> edges_;
  std::size_t left_;
  std::vector<std::uint32_t> vertices_;
  std::vector<NumberedBox> edge_boxes_, vertex_boxes_;
};

// Of each pair the later vertex moves to the first, unless one of them has moved.
std::size_t weld_near(FacetMesh& mesh, const Gaps& gaps) {
  std::vector<std::uint32_t> place(mesh.positions.size());
  std::iota(place.begin(), place.end(), 0U);
  std::size_t welded = 0;
  for (const auto& [first, later] : gaps.near_vertices) {
    if (place[first] != first || place[later] != later) continue;
    place[later] = first;
    ++welded;
  }
  for (auto& corners : mesh.facets)
    for (std::uint32_t& corner : corners) corner = place[corner];
  return welded;
}

// Splits every facet at one of its edges, at all vertices on it: a fan from the corner that the edge does not touch.
// The facet itself becomes the first piece.
std::size_t split_facets(FacetMesh& mesh, const std::vector<TJunction>& junctions) {
  std::size_t split = 0;
  for (std::size_t k = 0; k < junctions.size();) {
    const auto [facet, edge, vertex, along] = junctions[k];
    const auto corners = mesh.facets[facet];
    const std::uint32_t to = corners[(edge + 1) % 3], apex = corners[(edge + 2) % 3];
    mesh.facets[facet] = {corners[edge], vertex, apex};
    for (; k < junctions.size() && junctions[k].facet == facet && junctions[k].edge == edge; ++k, ++split) {
      const bool last = k + 1 == junctions.size() || junctions[k + 1].facet != facet || junctions[k + 1].edge != edge;
      add_facet_like(mesh, facet, {junctions[k].vertex, last ? to : junctions[k + 1].vertex, apex});
    }
    while (k < junctions.size() && junctions[k].facet == facet) ++k;  // its other edges: next time
  }
  return split;
}

}  // namespace

double usual_gap(const FacetMesh& mesh) {
  return usual_gap_of_diagonal * diagonal_of(mesh);
}

Gaps find_gaps(const FacetMesh& welded, double tolerance) {
  return GapSearch(welded, tolerance).run();
}

GapCounts close_gaps(FacetMesh& welded, double tolerance) {
  GapCounts counts;
  Gaps gaps = find_gaps(welded, tolerance);
  counts.complete = gaps.complete;
  counts.welded = weld_near(welded, gaps);
  // An edge at a time of each facet; what splitting leaves within the tolerance of the pieces' edges may come again.
  constexpr int most_rounds = 8;
  for (int round = 0; round < most_rounds; ++round) {
    drop_degenerate(welded);
    gaps = find_gaps(welded, tolerance);
    counts.complete &= gaps.complete;
    if (gaps.t_junctions.empty()) break;
    counts.t_junctions += split_facets(welded, gaps.t_junctions);
  }
  return counts;
}

}  // namespace lrcs
