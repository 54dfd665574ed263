#pragma once
#include <cstdint>
#include <vector>

#include "lrcs/occluders.h"

namespace lrcs {

// Coordinates along a viewing direction: x and y across the view, z toward the viewer; from the target's centre.
struct ViewFrame {
  Vec3 across, up, toward, centre;

  ViewFrame(const Vec3& toward_viewer, const Vec3& centre);
  [[nodiscard]] Vec3 at(const Vec3& p) const {
    const Vec3 q = p - centre;
    return {across.dot(q), up.dot(q), toward.dot(q)};
  }
};

// A box along the coordinate axes, or along those of a view.
struct Box3 {
  Vec3 low, high;
};
[[nodiscard]] inline bool overlap(const Box3& a, const Box3& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

// A tree of boxes over the facets of a target, built once. Nodes stand in depth-first order: the first child of node k
// is node k + 1. Facets stand in the order of Occluders, each node's side by side.
class FacetTree {
 public:
  struct Node {
    Box3 box;
    std::uint32_t first, last;  // facets [first, last)
    std::uint32_t skip;         // the node after this one's subtree
    bool leaf;
  };

  explicit FacetTree(const Occluders& occluders);

  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  // The largest size of a coordinate relative to the centre, rounded up.
  [[nodiscard]] double reach() const { return reach_; }

  // A box along the axes of the view that holds all of the node, rounding included.
  [[nodiscard]] Box3 seen_box(const Node& node, const ViewFrame& view) const;

  // The facets whose leaves' boxes overlap `box`. Appended to `found`, ascending.
  void overlapping(const Box3& box, std::vector<std::uint32_t>& found) const;
  // The facets whose leaves may overlap `box`, a box along the axes of the view, in projection, and are not all behind
  // it. Appended to `found`, ascending.
  void before(const ViewFrame& view, const Box3& box, std::vector<std::uint32_t>& found) const;

 private:
  void build(const Occluders& occluders, std::uint32_t first, std::uint32_t last, std::size_t place);

  std::vector<Node> nodes_;
  double reach_ = 0.0;
};

}  // namespace lrcs
