#include "lrcs/support_tree.h"

#include <algorithm>
#include <cmath>

#include "lrcs/plane_side.h"
#include "lrcs/space_order.h"

namespace lrcs {
namespace {

constexpr int exact_steps = 64;  // that one exact height takes as long as

}  // namespace

SupportTree::Plane::Plane(const Occluders& occluders, std::uint32_t facet, bool from_behind)
    : corners(occluders.facets[facet]), cross(occluders.cross[facet]) {
  if (!from_behind) return;
  std::swap(corners[1], corners[2]);
  cross = -cross;
}

SupportTree::SupportTree(const Occluders& occluders, std::span<const Vec3> normals,
                         std::span<const std::uint32_t> vertices)
    : occluders_(occluders), normals_(normals), vertices_(vertices) {
  nodes_.reserve(vertices.size() / 2 + 1);
  if (!vertices.empty()) build(0, static_cast<std::uint32_t>(vertices.size()));
}

void SupportTree::build(std::uint32_t first, std::uint32_t last) {
  const auto node = nodes_.size();
  nodes_.push_back(node_over(first, last));
  if (!nodes_[node].leaf) {
    build(first, middle_of(first, last));
    build(middle_of(first, last), last);
  }
  nodes_[node].skip = static_cast<std::uint32_t>(nodes_.size());
}

SupportTree::Node SupportTree::node_over(std::uint32_t first, std::uint32_t last) const {
  const auto& at = occluders_.positions;
  Box3 box{at[vertices_[first]], at[vertices_[first]]};
  Vec3 normal = Vec3::Zero();
  for (std::uint32_t k = first; k < last; ++k) {
    box.low = box.low.cwiseMin(at[vertices_[k]]);
    box.high = box.high.cwiseMax(at[vertices_[k]]);
    normal += normals_[vertices_[k]];
  }
  const Vec3 middle = 0.5 * box.low + 0.5 * box.high;
  const Vec3 along = normal.isZero(0.0) ? Vec3(Vec3::UnitZ()) : normal.stableNormalized();
  double high = along.dot(box.low - middle), radius = 0.0;
  for (std::uint32_t k = first; k < last; ++k) {
    const Vec3 offset = at[vertices_[k]] - middle;
    const double height = along.dot(offset);
    high = std::max(high, height);
    radius = std::max(radius, (offset - height * along).squaredNorm());
  }
  return {box, middle, along, high, std::sqrt(radius), first, last, 0, last - first <= space_leaf};
}

SupportTree::Bound SupportTree::bound(const Node& node, const Vec3& corner, const Vec3& cross) {
  double most = 0.0, size = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double term = cross[k] * ((cross[k] > 0.0 ? node.box.high[k] : node.box.low[k]) - corner[k]);
    most += term;
    size += std::abs(term);
  }
  // As FacetFrame::at_vertex().
  if (most <= -8.0 * unit_roundoff * size) return {most, true};
  const double along = cross.dot(node.along);
  if (along <= 0.0) return {most, false};
  // Its own rounding is added to what is left of a length when another is taken from it.
  const double across =
      std::sqrt(std::abs(cross.squaredNorm() - along * along) + 16.0 * unit_roundoff * cross.squaredNorm());
  const double by_cylinder = cross.dot(node.middle - corner) + along * node.high + across * node.radius;
  // Coordinates are below 2, a dozen roundings of their differences and products below this.
  const double rounding = 256.0 * unit_roundoff * cross.lpNorm<1>();
  return {std::min(most, by_cylinder), by_cylinder < -rounding};
}

std::uint32_t SupportTree::in_front(const Plane& plane, int& effort) const {
  return nodes_.empty() ? nothing : look_below(0, plane, effort);
}

// First where the way up seems longer.
std::uint32_t SupportTree::look_below(std::uint32_t node, const Plane& plane, int& effort) const {
  if (nodes_[node].leaf) return look_at_vertices(nodes_[node], plane, effort);
  if ((effort -= 2) < 0) return unknown;
  const Vec3& corner = occluders_.positions[plane.corners[0]];
  const std::array<std::uint32_t, 2> children{node + 1, nodes_[node + 1].skip};
  const std::array<Bound, 2> bounds{bound(nodes_[children[0]], corner, plane.cross),
                                    bound(nodes_[children[1]], corner, plane.cross)};
  const std::size_t higher = bounds[1].most > bounds[0].most ? 1 : 0;
  for (const std::size_t k : {higher, 1 - higher}) {
    if (bounds[k].clear) continue;
    const std::uint32_t found = look_below(children[k], plane, effort);
    if (found != nothing) return found;
  }
  return nothing;
}

std::uint32_t SupportTree::look_at_vertices(const Node& leaf, const Plane& plane, int& effort) const {
  const auto& at = occluders_.positions;
  const auto& [a, b, c] = plane.corners;
  for (std::uint32_t k = leaf.first; k < leaf.last; ++k) {
    const std::uint32_t v = vertices_[k];
    if (v == a || v == b || v == c) continue;
    auto side = certain_plane_side(at[a], plane.cross, at[v]);
    effort -= side ? 1 : exact_steps;
    if (effort < 0) return unknown;
    if (!side) side = plane_side(at[a], at[b], at[c], plane.cross, at[v]);
    if (*side > 0) return v;
  }
  return nothing;
}

}  // namespace lrcs
