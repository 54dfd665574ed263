#include "lrcs/facet_tree.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>

#include "base/large_pages.h"
#include "lrcs/space_order.h"

namespace lrcs {

ViewFrame::ViewFrame(const Vec3& toward_viewer, const Vec3& centre_)
    : across(toward_viewer.unitOrthogonal()), up(toward_viewer.cross(across)), toward(toward_viewer), centre(centre_) {}

namespace {

// How many nodes there are over n facets, and over n + 1.
std::array<std::size_t, 2> node_counts(std::uint32_t n) {
  if (n + 1 <= space_leaf) return {1, 1};
  const auto [low, high] = node_counts(n / 2);
  const std::array<std::size_t, 3> sums{1 + low + low, 1 + low + high, 1 + high + high};
  return {n <= space_leaf ? 1 : sums[n % 2], sums[n % 2 + 1]};
}

std::size_t node_count(std::uint32_t facets) {
  return node_counts(facets)[0];
}

}  // namespace

FacetTree::FacetTree(const Occluders& occluders) {
  if (occluders.size() == 0) return;
  const auto all = static_cast<std::uint32_t>(occluders.size());
  nodes_ = large_vector<Node>(node_count(all));
  build(occluders, 0, all, 0);
  const Box3& box = nodes_.front().box;
  reach_ = 2.0 * std::max((box.high - occluders.centre).cwiseAbs().maxCoeff(),
                          (box.low - occluders.centre).cwiseAbs().maxCoeff());
}

void FacetTree::build(const Occluders& occluders, std::uint32_t first, std::uint32_t last, std::size_t place) {
  Node& node = nodes_[place];
  const Vec3& any = occluders.positions[occluders.facets[first][0]];
  node = {{any, any},
          first,
          last,
          static_cast<std::uint32_t>(place + node_count(last - first)),
          last - first <= space_leaf};
  Box3& box = node.box;
  if (node.leaf) {
    for (std::uint32_t f = first; f < last; ++f)
      for (const std::uint32_t v : occluders.facets[f]) {
        box.low = box.low.cwiseMin(occluders.positions[v]);
        box.high = box.high.cwiseMax(occluders.positions[v]);
      }
    return;
  }
  const std::uint32_t middle = middle_of(first, last);
  const std::size_t left = place + 1, right = left + node_count(middle - first);
  constexpr std::uint32_t worth_a_thread = 4096;
  if (last - first >= worth_a_thread) {
    tbb::parallel_invoke([&] { build(occluders, first, middle, left); },
                         [&] { build(occluders, middle, last, right); });
  } else {
    build(occluders, first, middle, left);
    build(occluders, middle, last, right);
  }
  box.low = nodes_[left].box.low.cwiseMin(nodes_[right].box.low);
  box.high = nodes_[left].box.high.cwiseMax(nodes_[right].box.high);
}

namespace {

// Takes what lies below the nodes that pass.
template <class Pass>
void take(const std::vector<FacetTree::Node>& nodes, const Pass& pass, std::vector<std::uint32_t>& found) {
  for (std::uint32_t k = 0; k < nodes.size();) {
    const FacetTree::Node& node = nodes[k];
    if (!pass(node)) {
      k = node.skip;
      continue;
    }
    if (node.leaf)
      for (std::uint32_t f = node.first; f < node.last; ++f) found.push_back(f);
    ++k;
  }
}

}  // namespace

void FacetTree::overlapping(const Box3& box, std::vector<std::uint32_t>& found) const {
  take(
      nodes_, [&](const Node& node) { return overlap(node.box, box); }, found);
}

Box3 FacetTree::seen_box(const Node& node, const ViewFrame& view) const {
  // Three products and their sum, of lengths up to the reach: below 16 roundings.
  const double rounding = 16.0 * 0x1p-53 * reach_;
  const Vec3 offset = 0.5 * (node.box.low - view.centre) + 0.5 * (node.box.high - view.centre);
  const Vec3 middle(view.across.dot(offset), view.up.dot(offset), view.toward.dot(offset));
  const Vec3 half = 0.5 * (node.box.high - node.box.low);
  const Vec3 extent(view.across.cwiseAbs().dot(half) + rounding, view.up.cwiseAbs().dot(half) + rounding,
                    view.toward.cwiseAbs().dot(half) + rounding);
  return {middle - extent, middle + extent};
}

void FacetTree::before(const ViewFrame& view, const Box3& box, std::vector<std::uint32_t>& found) const {
  const auto pass = [&](const Node& node) {
    const Box3 seen = seen_box(node, view);
    return seen.low.x() <= box.high.x() && seen.high.x() >= box.low.x() && seen.low.y() <= box.high.y() &&
           seen.high.y() >= box.low.y() && seen.high.z() >= box.low.z();
  };
  take(nodes_, pass, found);
}

}  // namespace lrcs
