#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "base/estimate.h"
#include "lrcs/facet_frame.h"
#include "lrcs/facet_tree.h"
#include "lrcs/layer_count.h"
#include "lrcs/occluders.h"

namespace lrcs {

// The straight way to a facet's seen fraction: every facet that may stand before it is cut with its plane and
// projected, and the area is measured where the number of such layers is zero. Nothing is assumed of the target, and
// nothing is known from one facet to the next. The oracle for faster ways, and their last resort.
// One object a thread; its memory is used again from facet to facet.
class FacetView {
 public:
  FacetView(const Occluders& occluders, const FacetTree& tree)
      : occluders_(occluders), tree_(tree), memo_(occluders.positions.size()) {}

  // The directions to look along: one (monostatic), or two. Unit vectors toward the viewers.
  void look_along(const std::vector<Vec3>& directions);

  // value: the fraction of the facet's area that all viewers see, 0..1. 0 where viewers face different sides.
  [[nodiscard]] Estimate seen_fraction(std::uint32_t facet);

 private:
  struct Seen : FacetPoint {
    std::uint32_t stamp = 0;
  };
  struct KeyedEdge {
    std::uint64_t key;
    double u0, v0, u1, v1;
    int turns;
  };

  [[nodiscard]] bool add_layers(std::uint32_t facet, std::size_t viewer);
  [[nodiscard]] bool hidden_by(std::uint32_t blocker, std::uint32_t facet, std::size_t viewer);
  Seen& seen(std::uint32_t vertex);
  // Makes sure that the point where an edge passes the facet's plane is known as well as other points: to `slack`.
  void refine_cut(std::uint32_t a, std::uint32_t b, double slack);
  void add_outline(const std::array<std::uint32_t, 3>& ids, int turn, std::size_t viewer);
  void add_edge(std::uint64_t key, const FacetPoint& a, const FacetPoint& b, int turns);
  void sum_edges();

  const Occluders& occluders_;
  const FacetTree& tree_;
  std::vector<ViewFrame> viewers_;
  FacetFrame frame_;
  std::vector<Seen> memo_;
  std::uint32_t stamp_ = 0;
  double reach_ = 0.0;      // largest |x - t0| among the vertices of what may lie over the facet
  double cut_error_ = 0.0;  // largest error of a point where an edge passes the facet's plane
  std::uint64_t next_cut_ = 0;
  std::vector<std::uint32_t> before_;
  std::vector<KeyedEdge> keyed_;
  std::vector<LayerEdge> outline_;
  LayerCount count_;
};

// Does the blocker hide a coincident facet? The one whose front is seen comes first, then the lower number.
[[nodiscard]] inline bool ranks_before(const Occluders& occluders, std::uint32_t blocker, bool blocker_front,
                                       std::uint32_t facet, bool facet_front) {
  return blocker_front != facet_front ? blocker_front : occluders.original[blocker] < occluders.original[facet];
}

}  // namespace lrcs
