#include "lrcs/facet_tree.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace lrcs {
namespace {

constexpr ProjectedBox nothing{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

void include(ProjectedBox& box, const ProjectedBox& other) {
  box.x0 = std::min(box.x0, other.x0);
  box.x1 = std::max(box.x1, other.x1);
  box.y0 = std::min(box.y0, other.y0);
  box.y1 = std::max(box.y1, other.y1);
  box.far = std::min(box.far, other.far);
  box.near = std::max(box.near, other.near);
}

}  // namespace

FacetTree::FacetTree(const FacetMesh& mesh, std::vector<std::uint32_t> facets) : order_(std::move(facets)) {
  std::vector<Vec3> centres(mesh.size());
  for (const std::uint32_t f : order_) {
    const auto [a, b, c] = mesh.corners(f);
    centres[f] = a / 3.0 + b / 3.0 + c / 3.0;
  }
  nodes_.reserve(order_.size() / 2 + 1);
  if (!order_.empty()) build(centres, 0, static_cast<std::uint32_t>(order_.size()));
}

// Halving by number keeps the depth of the recursion at log2 of the number of facets, whatever their shape.
void FacetTree::build(const std::vector<Vec3>& centres, std::uint32_t first, std::uint32_t last) {
  const auto node = nodes_.size();
  nodes_.push_back({first, last, 0, last - first <= leaf_size});
  if (!nodes_[node].leaf) {
    Vec3 low = centres[order_[first]];
    Vec3 high = low;
    for (std::uint32_t k = first; k < last; ++k) {
      low = low.cwiseMin(centres[order_[k]]);
      high = high.cwiseMax(centres[order_[k]]);
    }
    int axis = 0;
    (high - low).maxCoeff(&axis);
    const std::uint32_t middle = first + (last - first) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                     [&](std::uint32_t a, std::uint32_t b) {
                       return std::pair(centres[a][axis], a) < std::pair(centres[b][axis], b);
                     });
    build(centres, first, middle);
    build(centres, middle, last);
  }
  nodes_[node].skip = static_cast<std::uint32_t>(nodes_.size());
}

void ProjectedTree::project(const FacetTree& tree, const FacetMesh& mesh, const Vec3& toward_viewer) {
  const Vec3 across = toward_viewer.unitOrthogonal();
  const Vec3 up = toward_viewer.cross(across);
  double size = 0.0;
  vertices_.resize(mesh.positions.size());
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    const Vec3& p = mesh.positions[v];
    vertices_[v] = {p.dot(across), p.dot(up), p.dot(toward_viewer)};
    size = std::max(size, p.cwiseAbs().maxCoeff());
  }
  // A dot product of three terms is off by less than 3 u |p|_1 <= 9 u |p|_max (u = 2^-53).
  const double rounding = 16.0 * 0x1p-53 * size;
  facets_.resize(tree.order().size());
  for (std::size_t k = 0; k < facets_.size(); ++k) {
    const auto& f = mesh.facets[tree.order()[k]];
    const Vec3 low = vertices_[f[0]].cwiseMin(vertices_[f[1]]).cwiseMin(vertices_[f[2]]);
    const Vec3 high = vertices_[f[0]].cwiseMax(vertices_[f[1]]).cwiseMax(vertices_[f[2]]);
    facets_[k] = {low.x() - rounding,  high.x() + rounding, low.y() - rounding,
                  high.y() + rounding, low.z() - rounding,  high.z() + rounding};
  }
  nodes_.resize(tree.nodes().size());
  for (std::size_t k = nodes_.size(); k-- > 0;) {
    const FacetTree::Node& node = tree.nodes()[k];
    nodes_[k] = nothing;
    if (node.leaf) {
      for (std::uint32_t f = node.first; f < node.last; ++f) include(nodes_[k], facets_[f]);
    } else {
      include(nodes_[k], nodes_[k + 1]);
      include(nodes_[k], nodes_[tree.nodes()[k + 1].skip]);
    }
  }
}

void ProjectedTree::overlapping(const FacetTree& tree, const ProjectedBox& box,
                                std::vector<std::uint32_t>& found) const {
  for (std::uint32_t k = 0; k < nodes_.size();) {
    const FacetTree::Node& node = tree.nodes()[k];
    if (!overlaps(nodes_[k], box) || nodes_[k].near < box.far) {
      k = node.skip;
      continue;
    }
    if (node.leaf)
      for (std::uint32_t f = node.first; f < node.last; ++f)
        if (overlaps(facets_[f], box) && facets_[f].near >= box.far) found.push_back(f);
    ++k;
  }
}

}  // namespace lrcs
