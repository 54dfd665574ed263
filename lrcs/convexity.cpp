#include "lrcs/convexity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "lrcs/plane_side.h"

namespace lrcs {
namespace {

// How far the surface that a facet stands for rises over it, over the facet's size: its plane may lean by a few times
// that from the surface's.
double lean_of(const FacetMesh& mesh, std::size_t facet, double size) {
  if (mesh.curved.of.empty() || mesh.curved.of[facet] == CurvedFacets::flat || !(size > 0.0)) return 0.0;
  double rise = 0.0;
  for (const Vec3& sagitta : mesh.curved.patches[mesh.curved.of[facet]].sagitta) rise = std::max(rise, sagitta.norm());
  constexpr double few = 4.0;
  return few * rise / size;
}

// Do facets of the mesh as given certainly have a corner of another before them, further than their curvature explains?
// Looks at a few facets only.
bool has_something_before_its_facets(const FacetMesh& mesh) {
  constexpr std::size_t looked_at = 8;
  const std::size_t count = std::min(looked_at, mesh.size());
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t facet = k * mesh.size() / count;
    const auto [a, b, c] = mesh.corners(facet);
    const Vec3 cross = facet_cross(a, b, c);
    const double size = std::sqrt(cross.norm()), lean = lean_of(mesh, facet, size) * cross.norm();
    const auto is_before = [&, a = a](std::uint32_t v) {
      const Vec3 to = mesh.positions[v] - a, terms = to.cwiseProduct(cross);
      return terms.sum() > 16.0 * unit_roundoff * terms.lpNorm<1>() + lean * (size + to.norm());
    };
    if (std::ranges::any_of(mesh.facets, [&](const auto& f) { return std::ranges::any_of(f, is_before); })) return true;
  }
  return false;
}

// Of some facets of a surface that has all that stands at their edges.
class ConvexityCheck {
 public:
  ConvexityCheck(const Occluders& occluders, const OccluderEdges& edges, std::span<const std::uint32_t> facets)
      : occluders_(occluders), edges_(edges), facets_(facets) {
    for (const std::uint32_t f : facets)
      for (const Vec3& p : corners(f)) middle_ += p / static_cast<double>(3 * facets.size());
  }

  [[nodiscard]] bool holds() const {
    return facets_.size() >= 4 && bends_back_at_every_edge() && has_its_middle_behind_every_facet() &&
           goes_round_once();
  }

 private:
  [[nodiscard]] std::array<Vec3, 3> corners(std::uint32_t f) const {
    const auto& c = occluders_.facets[f];
    return {occluders_.positions[c[0]], occluders_.positions[c[1]], occluders_.positions[c[2]]};
  }
  [[nodiscard]] int side(std::uint32_t facet, const Vec3& p) const {
    const auto [a, b, c] = corners(facet);
    return plane_side(a, b, c, occluders_.cross[facet], p);
  }

  // The facet's corner that is not at the edge.
  [[nodiscard]] std::uint32_t other_corner(std::uint32_t facet, const OccluderEdges::Edge& edge) const {
    const auto& c = occluders_.facets[facet];
    return *std::ranges::find_if_not(c, [&](std::uint32_t v) { return v == edge.low || v == edge.high; });
  }
  [[nodiscard]] const Vec3& opposite(std::uint32_t facet, const OccluderEdges::Edge& edge) const {
    return occluders_.positions[other_corner(facet, edge)];
  }

  [[nodiscard]] bool bends_back_at_every_edge() const {
    return std::ranges::all_of(facets_, [&](std::uint32_t f) {
      return bends_back_at(f, edges_.edge_of(f, 0)) && bends_back_at(f, edges_.edge_of(f, 1)) &&
             bends_back_at(f, edges_.edge_of(f, 2));
    });
  }
  [[nodiscard]] bool bends_back_at(std::uint32_t facet, std::uint32_t edge) const {
    const auto uses = edges_.facets_at(edge);
    if (uses.size() != 2 || uses[0].rising == uses[1].rising) return false;
    // The same for both facets there.
    return uses[0].facet != facet || side(facet, opposite(uses[1].facet, edges_.edges()[edge])) <= 0 ||
           surface_bends_back(facet, uses[1].facet, edges_.edges()[edge]);
  }
  // Of curved surfaces, which the edge's facets stand for: smooth there, and its normals turn apart across the edge.
  // Where the diagonal that the facets do not share passes the edge, it may stand over it by what the surface does.
  [[nodiscard]] bool surface_bends_back(std::uint32_t facet, std::uint32_t other,
                                        const OccluderEdges::Edge& edge) const {
    if (occluders_.corner_normals.empty() || !is_smooth_at(facet, other, edge.low) ||
        !is_smooth_at(facet, other, edge.high))
      return false;
    const Vec3 &low = occluders_.positions[edge.low], &high = occluders_.positions[edge.high];
    const Vec3 apart = normal_at(other, other_corner(other, edge)) - normal_at(facet, other_corner(facet, edge));
    const double rise = (normal_at(facet, edge.high) - normal_at(facet, edge.low)).dot(high - low) / 8.0;
    const double own = occluders_.cross[facet].stableNorm(), beyond = occluders_.cross[other].stableNorm();
    const double over = (occluders_.cross[facet] / own).dot(opposite(other, edge) - low) * own / (own + beyond);
    constexpr double third_order = 1.5;  // what is said here is right to second order in the facets' size
    return apart.dot(opposite(other, edge) - opposite(facet, edge)) > 0.0 && over <= third_order * rise;
  }
  [[nodiscard]] bool is_smooth_at(std::uint32_t facet, std::uint32_t other, std::uint32_t vertex) const {
    return normal_at(facet, vertex).dot(normal_at(other, vertex)) > Occluders::smooth;
  }
  [[nodiscard]] const Vec3& normal_at(std::uint32_t facet, std::uint32_t vertex) const {
    const auto& c = occluders_.facets[facet];
    return occluders_.corner_normals[facet][static_cast<std::size_t>(std::ranges::find(c, vertex) - c.begin())];
  }

  [[nodiscard]] bool has_its_middle_behind_every_facet() const {
    return std::ranges::all_of(facets_, [&](std::uint32_t f) { return side(f, middle_) < 0; });
  }

  // The ray from the middle through a facet passes no other one. One that may pass through an edge counts too.
  [[nodiscard]] bool goes_round_once() const {
    const auto [a, b, c] = corners(facets_[0]);
    const Vec3 through = a / 3.0 + b / 3.0 + c / 3.0;
    return std::ranges::count_if(facets_, [&](std::uint32_t f) { return is_passed(f, through); }) == 1;
  }
  [[nodiscard]] bool is_passed(std::uint32_t facet, const Vec3& through) const {
    const auto p = corners(facet);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &from = p[k], &to = p[(k + 1) % 3];
      if (plane_side(middle_, from, to, facet_cross(middle_, from, to), through) < 0) return false;
    }
    return true;
  }

  const Occluders& occluders_;
  const OccluderEdges& edges_;
  std::span<const std::uint32_t> facets_;
  Vec3 middle_ = Vec3::Zero();
};

}  // namespace

bool is_convex_body(const FacetMesh& mesh) {
  if (mesh.size() < 4 || has_something_before_its_facets(mesh)) return false;
  const Occluders occluders(mesh);
  std::vector<std::uint32_t> all(occluders.size());
  std::iota(all.begin(), all.end(), 0U);
  return is_convex_body(occluders, OccluderEdges(occluders), all);
}

bool is_convex_body(const Occluders& occluders, const OccluderEdges& edges, std::span<const std::uint32_t> facets) {
  return ConvexityCheck(occluders, edges, facets).holds();
}

}  // namespace lrcs
