#include "lrcs/layer_query.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lrcs/facet_frame.h"
#include "lrcs/facet_view.h"

namespace lrcs {
namespace {

// Does a line from a place toward the viewer pass a box, wider on all sides by the rounding? `inverse`: of the
// direction.
bool may_pass(const Vec3& from, const Vec3& inverse, const Box3& box, double rounding) {
  double enter = 0.0, leave = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const double low = box.low[k] - rounding - from[k], high = box.high[k] + rounding - from[k];
    if (std::isinf(inverse[k])) {
      if (low > 0.0 || high < 0.0) return false;
      continue;
    }
    const double a = low * inverse[k], b = high * inverse[k];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}

// On which side of a facet's plane another facet lies, as one of its fronts (+1), its backs (-1), in it (0) or across
// it (2).
int side_of_plane(const Occluders& occluders, std::uint32_t plane, std::uint32_t facet) {
  FacetFrame frame(occluders, plane);
  frame.turn(occluders.cross[plane].stableNormalized());
  bool front = false, back = false;
  for (const std::uint32_t v : occluders.facets[facet]) {
    FacetPoint p = frame.at_vertex(v);
    if (!p.sign_is_certain()) frame.refine(p, v);
    front = front || p.height > 0.0;
    back = back || p.height < 0.0;
  }
  return front && back ? 2 : front ? 1 : back ? -1 : 0;
}

}  // namespace

LayerQuery::LayerQuery(const Occluders& occluders, const FacetTree& tree, const ViewFrame& view)
    : occluders_(occluders), tree_(tree), view_(view), inverse_(view.toward.cwiseInverse()) {}

std::optional<LayerQuery::Before> LayerQuery::count(std::uint32_t facet, double u, double v,
                                                    const Facing& facing) const {
  const auto& ids = occluders_.facets[facet];
  const auto& at = occluders_.positions;
  // Relative to the centre: far from the origin, the place itself is rounded more than the view's coordinates are.
  const Vec3 a = view_.at(at[ids[0]]), b = view_.at(at[ids[1]]), c = view_.at(at[ids[2]]);
  const Vec3 seen = a + u * (b - a) + v * (c - a);
  const Vec3 place = at[ids[0]] + u * (at[ids[1]] - at[ids[0]]) + v * (at[ids[2]] - at[ids[0]]);
  const double rounding = unit_roundoff * (64.0 * tree_.reach() + 8.0 * at[ids[0]].cwiseAbs().maxCoeff());
  const auto& nodes = tree_.nodes();
  Before before;
  for (std::uint32_t k = 0; k < nodes.size();) {
    const FacetTree::Node& node = nodes[k];
    if (!may_pass(place, inverse_, node.box, rounding)) {
      k = node.skip;
      continue;
    }
    for (std::uint32_t f = node.first; node.leaf && f < node.last; ++f) {
      const int its_facing = f == facet ? 0 : facing(f);
      if (its_facing == 0) continue;
      const Answer answer = is_before(f, its_facing, facet, seen);
      if (answer == Answer::unsure) return std::nullopt;
      if (answer == Answer::no) continue;
      ++before.layers;
      before.windings += its_facing;
    }
    ++k;
  }
  return before;
}

LayerQuery::Answer LayerQuery::is_before(std::uint32_t other, int other_facing, std::uint32_t facet,
                                         const Vec3& p) const {
  const auto& ids = occluders_.facets[other];
  const std::array<Vec3, 3> corner{view_.at(occluders_.positions[ids[0]]), view_.at(occluders_.positions[ids[1]]),
                                   view_.at(occluders_.positions[ids[2]])};
  // Three products and their sum, of lengths up to the reach: below 16 roundings.
  const double rounding = 16.0 * unit_roundoff * tree_.reach();
  std::array<double, 3> weight{};
  double sum = 0.0, doubt = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &a = corner[(k + 1) % 3], &b = corner[(k + 2) % 3];
    const double ex = b.x() - a.x(), ey = b.y() - a.y(), px = p.x() - a.x(), py = p.y() - a.y();
    weight[k] = other_facing * (ex * py - ey * px);
    const double error = 4.0 * rounding * (std::abs(ex) + std::abs(ey) + std::abs(px) + std::abs(py));
    if (weight[k] < -error) return Answer::no;
    if (weight[k] <= error) return Answer::unsure;
    sum += weight[k];
    doubt += error;
  }
  const auto [low, high] = std::minmax({corner[0].z(), corner[1].z(), corner[2].z()});
  const double depth = (weight[0] * corner[0].z() + weight[1] * corner[1].z() + weight[2] * corner[2].z()) / sum;
  const double error = 4.0 * rounding + 2.0 * doubt / sum * (high - low);
  if (depth > p.z() + error) return Answer::yes;
  if (depth < p.z() - error) return Answer::no;
  return is_before_by_planes(other, other_facing, facet);
}

// Two facets that overlap in projection and do not pass through each other: which is nearer.
LayerQuery::Answer LayerQuery::is_before_by_planes(std::uint32_t other, int other_facing, std::uint32_t facet) const {
  const bool front = occluders_.cross[facet].dot(view_.toward) > 0.0;
  const int side = side_of_plane(occluders_, facet, other);
  if (side == 0) return ranks_before(occluders_, other, other_facing > 0, facet, front) ? Answer::yes : Answer::no;
  if (side != 2) return (side > 0) == front ? Answer::yes : Answer::no;
  const int own_side = side_of_plane(occluders_, other, facet);
  if (own_side == 2) return Answer::unsure;
  return (own_side > 0) == (other_facing > 0) ? Answer::no : Answer::yes;
}

}  // namespace lrcs
