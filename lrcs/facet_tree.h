#pragma once
#include <cstdint>
#include <vector>

#include "base/vec3.h"
#include "mesh/facet_mesh.h"

namespace lrcs {

// The box of something projected along a viewing direction: across the view (x, y), and its depth range toward the
// viewer.
struct ProjectedBox {
  double x0, x1, y0, y1;  // [m]
  double far, near;       // [m] along the direction to the viewer; near >= far
};

// A tree over the facets of a target, built once. Nodes stand in depth-first order: the first child of node k is node k
// + 1.
class FacetTree {
 public:
  struct Node {
    std::uint32_t first, last;  // facets order()[first, last)
    std::uint32_t skip;         // the node after this one's subtree
    bool leaf;
  };
  static constexpr std::uint32_t leaf_size = 8;

  // `facets`: the facets to hold, others are left out.
  FacetTree(const FacetMesh& mesh, std::vector<std::uint32_t> facets);

  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }

 private:
  void build(const std::vector<Vec3>& centres, std::uint32_t first, std::uint32_t last);

  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

// The boxes of all facets (in the tree's order) and nodes for one viewing direction, each widened by the rounding
// error.
class ProjectedTree {
 public:
  void project(const FacetTree& tree, const FacetMesh& mesh, const Vec3& toward_viewer);

  // Facets (places in the tree's order) whose boxes overlap `box` and are not all behind it. Appended to `found`.
  void overlapping(const FacetTree& tree, const ProjectedBox& box, std::vector<std::uint32_t>& found) const;

  [[nodiscard]] const ProjectedBox& box_of(std::uint32_t place) const { return facets_[place]; }
  [[nodiscard]] const ProjectedBox& box_of_node(std::uint32_t node) const { return nodes_[node]; }

 private:
  std::vector<Vec3> vertices_;
  std::vector<ProjectedBox> facets_;
  std::vector<ProjectedBox> nodes_;
};

[[nodiscard]] inline bool overlaps(const ProjectedBox& a, const ProjectedBox& b) {
  return a.x0 <= b.x1 && b.x0 <= a.x1 && a.y0 <= b.y1 && b.y0 <= a.y1;
}

}  // namespace lrcs
