#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/estimate.h"
#include "lrcs/facet_tree.h"
#include "lrcs/layer_count.h"
#include "mesh/facet_mesh.h"

namespace lrcs {

// One facet after another, looked at along one or two directions, and what stands before it: the work behind
// Visibility. One object a thread; its memory is used again from facet to facet. domain: a mesh without zero-area
// facets whose vertices of equal position are one.
class FacetView {
 public:
  FacetView(const FacetMesh& mesh, const FacetTree& tree) : mesh_(mesh), tree_(tree), memo_(mesh.positions.size()) {}

  // The directions to look along: one (monostatic), or two. Unit vectors toward the viewers.
  void look_along(const std::vector<Vec3>& directions);

  // value: the fraction of every facet's area that all viewers see, 0..1. 0 where viewers face different sides.
  // shape: `fraction` has an entry for every facet of the mesh; facets outside the tree are left as they are.
  void seen_fractions(std::vector<Estimate>& fraction);

 private:
  // A vertex relative to the facet looked at: x - t0 = u e1 + v e2 + (depth) d, and its height over the facet's plane.
  struct Seen {
    double u, v, height;
    double error;  // |height - true height| <= error; its sign is certain where error < |height|, or error == 0
    std::uint32_t stamp = 0;

    [[nodiscard]] bool sign_is_certain() const { return std::abs(height) > error || error == 0.0; }
  };
  struct Frame {
    Vec3 origin, e1, e2, normal;       // the facet; normal = e1 x e2, not normalised
    std::array<std::uint32_t, 3> ids;  // its vertices: origin, origin + e1, origin + e2
    Vec3 to_u, to_v;                   // rows that give u and v
    double facing;                     // +1: the front is seen, -1: the back
    double stretch;                    // change of (u, v) per unit of length across the view, at most
    double scale;                      // relative error of the projection's scale, in units of 2^-53
  };
  struct KeyedEdge {
    std::uint64_t key;
    double u0, v0, u1, v1;
    int turns;
  };
  struct Viewer {
    Vec3 direction;
    ProjectedTree projected;
    std::vector<std::uint32_t> near_leaf;  // places of the facets that may stand before one of the leaf at hand
  };

  [[nodiscard]] Estimate seen_fraction(std::uint32_t place);

  void set_frame(std::uint32_t facet);
  // How surely a viewer sees the facet edge-on: exactly, or as far as rounding can tell.
  enum class EdgeOn { no, perhaps, exactly };
  [[nodiscard]] EdgeOn edge_on(const Vec3& direction) const;
  [[nodiscard]] bool one_side_faces_all() const;
  void turn_frame(const Vec3& direction);
  [[nodiscard]] bool add_layers(std::uint32_t place, std::size_t viewer);
  [[nodiscard]] bool hidden_by(std::uint32_t blocker, std::uint32_t facet, std::size_t viewer);
  const Seen& seen(std::uint32_t vertex);
  void refine(std::uint32_t vertex);
  // Makes sure that the point where an edge passes the facet's plane is known as well as other points: to `slack`.
  void refine_cut(std::uint32_t a, std::uint32_t b, double slack);
  [[nodiscard]] bool ranks_before(std::uint32_t blocker, std::uint32_t facet, const Vec3& direction) const;
  void add_outline(const std::array<std::uint32_t, 3>& ids, int turn, std::size_t viewer);
  void add_edge(std::uint64_t key, const Seen& a, const Seen& b, int turns);
  void sum_edges();

  const FacetMesh& mesh_;
  const FacetTree& tree_;
  std::vector<Viewer> viewers_;
  Frame frame_{};
  std::vector<Seen> memo_;
  std::uint32_t stamp_ = 0;
  double reach_ = 0.0;      // largest |x - t0| among the vertices of the layers
  double cut_error_ = 0.0;  // largest error of a point where an edge passes the facet's plane
  std::uint64_t next_cut_ = 0;
  std::vector<KeyedEdge> keyed_;
  std::vector<LayerEdge> outline_;
  LayerCount count_;
};

}  // namespace lrcs
