#include "lrcs/convexity.h"

#include <algorithm>
#include <array>

#include "lrcs/occluder_edges.h"
#include "lrcs/occluders.h"
#include "lrcs/plane_side.h"

namespace lrcs {
namespace {

// Does a facet of the mesh as given certainly have a corner of another before it? Looks at a few facets only.
bool has_something_before_a_facet(const FacetMesh& mesh) {
  constexpr std::size_t looked_at = 8;
  for (std::size_t k = 0; k < looked_at; ++k) {
    const auto [a, b, c] = mesh.corners(k * mesh.size() / looked_at);
    const Vec3 cross = facet_cross(a, b, c);
    for (const auto& facet : mesh.facets)
      for (const std::uint32_t v : facet) {
        const Vec3 terms = (mesh.positions[v] - a).cwiseProduct(cross);
        if (terms.sum() > 16.0 * unit_roundoff * terms.lpNorm<1>()) return true;
      }
  }
  return false;
}

class ConvexityCheck {
 public:
  explicit ConvexityCheck(const FacetMesh& mesh) : occluders_(mesh), edges_(occluders_) {
    for (const Vec3& p : occluders_.positions) middle_ += p / static_cast<double>(occluders_.positions.size());
  }

  [[nodiscard]] bool holds() const {
    return occluders_.size() >= 4 && bends_back_at_every_edge() && has_its_middle_behind_every_facet() &&
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
  [[nodiscard]] const Vec3& opposite(std::uint32_t facet, const OccluderEdges::Edge& edge) const {
    const auto& c = occluders_.facets[facet];
    const auto at_edge = [&](std::uint32_t v) { return v == edge.low || v == edge.high; };
    return occluders_.positions[*std::find_if_not(c.begin(), c.end(), at_edge)];
  }

  [[nodiscard]] bool bends_back_at_every_edge() const {
    for (std::uint32_t e = 0; e < edges_.edges().size(); ++e) {
      const auto uses = edges_.facets_at(e);
      if (uses.size() != 2 || uses[0].rising == uses[1].rising) return false;
      if (side(uses[0].facet, opposite(uses[1].facet, edges_.edges()[e])) > 0) return false;
    }
    return true;
  }

  [[nodiscard]] bool has_its_middle_behind_every_facet() const {
    for (std::uint32_t f = 0; f < occluders_.size(); ++f)
      if (side(f, middle_) >= 0) return false;
    return true;
  }

  // The ray from the middle through a facet passes no other one. One that may pass through an edge counts too.
  [[nodiscard]] bool goes_round_once() const {
    const auto [a, b, c] = corners(0);
    const Vec3 through = a / 3.0 + b / 3.0 + c / 3.0;
    std::size_t passed = 0;
    for (std::uint32_t f = 0; f < occluders_.size(); ++f) passed += is_passed(f, through) ? 1 : 0;
    return passed == 1;
  }
  [[nodiscard]] bool is_passed(std::uint32_t facet, const Vec3& through) const {
    const auto p = corners(facet);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &from = p[k], &to = p[(k + 1) % 3];
      if (plane_side(middle_, from, to, facet_cross(middle_, from, to), through) < 0) return false;
    }
    return true;
  }

  Occluders occluders_;
  OccluderEdges edges_;
  Vec3 middle_ = Vec3::Zero();
};

}  // namespace

bool is_convex_body(const FacetMesh& mesh) {
  return mesh.size() >= 4 && !has_something_before_a_facet(mesh) && ConvexityCheck(mesh).holds();
}

}  // namespace lrcs
