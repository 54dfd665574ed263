#include "lrcs/layer_query.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lrcs/facet_frame.h"
#include "lrcs/facet_view.h"

namespace lrcs {
namespace {

// A line from a place toward the viewer, and what is certainly not on it.
class SightLine {
 public:
  SightLine(const Vec3& from, const Vec3& toward, double rounding)
      : from_(from), inverse_(toward.cwiseInverse()), rounding_(rounding) {}

  [[nodiscard]] bool may_pass(const Box3& box) const {
    double enter = 0.0, leave = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
      const double low = box.low[k] - rounding_ - from_[k], high = box.high[k] + rounding_ - from_[k];
      if (std::isinf(inverse_[k])) {
        if (low > 0.0 || high < 0.0) return false;
        continue;
      }
      const double a = low * inverse_[k], b = high * inverse_[k];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave;
  }

 private:
  Vec3 from_, inverse_;
  double rounding_;
};

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

std::optional<int> LayerQuery::layers_over(std::uint32_t facet, const Vec3& place) const {
  const Vec3 seen = view_.frame().at(place);
  const double rounding = 4.0 * view_.rounding();
  const SightLine line(place, view_.frame().toward, rounding);
  const auto& nodes = surface_.tree.nodes();
  int layers = 0;
  for (std::uint32_t k = 0; k < nodes.size();) {
    const FacetTree::Node& node = nodes[k];
    if (!line.may_pass(node.box)) {
      k = node.skip;
      continue;
    }
    for (std::uint32_t f = node.first; node.leaf && f < node.last; ++f) {
      if (f == facet || view_.counted()[f] == 0) continue;
      const Answer answer = is_before(f, facet, seen);
      if (answer == Answer::unsure) return std::nullopt;
      layers += answer == Answer::yes ? 1 : 0;
    }
    ++k;
  }
  return layers;
}

LayerQuery::Answer LayerQuery::is_before(std::uint32_t other, std::uint32_t facet, const Vec3& p) const {
  const auto& ids = surface_.occluders.facets[other];
  const double* const x = view_.x();
  const double* const y = view_.y();
  const double* const z = view_.z();
  const double rounding = view_.rounding();
  std::array<double, 3> weight{};
  double sum = 0.0, doubt = 0.0;
  const double facing = view_.facing()[other];
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t a = ids[(k + 1) % 3], b = ids[(k + 2) % 3];
    const double ex = x[b] - x[a], ey = y[b] - y[a], px = p.x() - x[a], py = p.y() - y[a];
    weight[k] = facing * (ex * py - ey * px);
    const double error = 4.0 * rounding * (std::abs(ex) + std::abs(ey) + std::abs(px) + std::abs(py));
    if (weight[k] < -error) return Answer::no;
    if (weight[k] <= error) return Answer::unsure;
    sum += weight[k];
    doubt += error;
  }
  const auto [low, high] = std::minmax({z[ids[0]], z[ids[1]], z[ids[2]]});
  const double depth = (weight[0] * z[ids[0]] + weight[1] * z[ids[1]] + weight[2] * z[ids[2]]) / sum;
  const double error = 4.0 * rounding + 2.0 * doubt / sum * (high - low);
  if (depth > p.z() + error) return Answer::yes;
  if (depth < p.z() - error) return Answer::no;
  return is_before_by_planes(other, facet);
}

// Two facets that overlap in projection and do not pass through each other: which is nearer.
LayerQuery::Answer LayerQuery::is_before_by_planes(std::uint32_t other, std::uint32_t facet) const {
  const bool front = view_.facing()[facet] > 0, other_front = view_.facing()[other] > 0;
  const int side = side_of_plane(surface_.occluders, facet, other);
  if (side == 0) return ranks_before(surface_.occluders, other, other_front, facet, front) ? Answer::yes : Answer::no;
  if (side != 2) return (side > 0) == front ? Answer::yes : Answer::no;
  const int own_side = side_of_plane(surface_.occluders, other, facet);
  if (own_side == 2) return Answer::unsure;
  return (own_side > 0) == other_front ? Answer::no : Answer::yes;
}

}  // namespace lrcs
