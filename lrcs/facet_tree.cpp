#include "lrcs/facet_tree.h"

#include <algorithm>

#include "lrcs/space_order.h"

namespace lrcs {

ViewFrame::ViewFrame(const Vec3& toward_viewer, const Vec3& centre_)
    : across(toward_viewer.unitOrthogonal()), up(toward_viewer.cross(across)), toward(toward_viewer), centre(centre_) {}

FacetTree::FacetTree(const Occluders& occluders) {
  if (occluders.size() == 0) return;
  nodes_.reserve(occluders.size() / 2 + 1);
  build(occluders, 0, static_cast<std::uint32_t>(occluders.size()));
  const Box3& all = nodes_.front().box;
  reach_ = 2.0 * std::max((all.high - occluders.centre).cwiseAbs().maxCoeff(),
                          (all.low - occluders.centre).cwiseAbs().maxCoeff());
}

void FacetTree::build(const Occluders& occluders, std::uint32_t first, std::uint32_t last) {
  const auto node = nodes_.size();
  const Vec3& any = occluders.positions[occluders.facets[first][0]];
  nodes_.push_back({{any, any}, first, last, 0, last - first <= space_leaf});
  Box3 box = nodes_[node].box;
  if (nodes_[node].leaf) {
    for (std::uint32_t f = first; f < last; ++f)
      for (const std::uint32_t v : occluders.facets[f]) {
        box.low = box.low.cwiseMin(occluders.positions[v]);
        box.high = box.high.cwiseMax(occluders.positions[v]);
      }
  } else {
    const std::uint32_t middle = middle_of(first, last);
    build(occluders, first, middle);
    const auto second = nodes_.size();
    build(occluders, middle, last);
    box.low = nodes_[node + 1].box.low.cwiseMin(nodes_[second].box.low);
    box.high = nodes_[node + 1].box.high.cwiseMax(nodes_[second].box.high);
  }
  nodes_[node].box = box;
  nodes_[node].skip = static_cast<std::uint32_t>(nodes_.size());
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
