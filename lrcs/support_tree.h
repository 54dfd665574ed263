#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lrcs/facet_tree.h"
#include "lrcs/occluders.h"

namespace lrcs {

// A tree over some vertices of a target that tells whether any lies in front of a facet's plane.
// A node knows two bounds of its vertices: a box, which is exact for planes along the axes, and a cylinder about their
// mean normal, which fits a curved surface: far fewer nodes of it than boxes reach above a tangent plane.
class SupportTree {
 public:
  // vertices: such that those that stand together lie together, as those of Occluders do. normals: of all vertices, of
  // any length. Refers to all three.
  SupportTree(const Occluders& occluders, std::span<const Vec3> normals, std::span<const std::uint32_t> vertices);

  // The plane of a facet, or the same seen from behind.
  struct Plane {
    std::array<std::uint32_t, 3> corners;
    Vec3 cross;  // facet_cross() of the corners

    Plane(const Occluders& occluders, std::uint32_t facet, bool from_behind);
  };
  static constexpr std::uint32_t nothing = 0xffffffff;
  static constexpr std::uint32_t unknown = 0xfffffffe;
  // A vertex that is in front of the plane, exactly; nothing; or unknown, where `effort` (steps) is spent before it is
  // told. Takes from `effort` what it spends.
  [[nodiscard]] std::uint32_t in_front(const Plane& plane, int& effort) const;

 private:
  struct Node {
    Box3 box;
    Vec3 middle, along;   // the cylinder's, a unit vector
    double high, radius;  // of the vertices, from the middle: along the axis, at most, and across it
    std::uint32_t first, last, skip;
    bool leaf;
  };
  struct Bound {
    double most;  // height over the plane, times the length of `cross`
    bool clear;   // certainly nothing is in front
  };

  void build(std::uint32_t first, std::uint32_t last);
  [[nodiscard]] Node node_over(std::uint32_t first, std::uint32_t last) const;
  [[nodiscard]] static Bound bound(const Node& node, const Vec3& corner, const Vec3& cross);
  [[nodiscard]] std::uint32_t look_below(std::uint32_t node, const Plane& plane, int& effort) const;
  [[nodiscard]] std::uint32_t look_at_vertices(const Node& leaf, const Plane& plane, int& effort) const;

  const Occluders& occluders_;
  std::span<const Vec3> normals_;
  std::span<const std::uint32_t> vertices_;
  std::vector<Node> nodes_;
};

}  // namespace lrcs
