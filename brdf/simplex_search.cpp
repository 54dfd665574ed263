#include "brdf/simplex_search.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

namespace lrcs {
namespace {

constexpr std::size_t leaf_cells = 4;
constexpr int most_steps = 10000;  // a walk that needs more goes in circles, which only rounding can make it do

template <int D>
using Weights = std::array<double, D + 1>;

// The volumes (times D!) of the simplices that the point makes with each face: all >= 0 inside.
template <int D>
Weights<D> volumes(const SimplexMesh<D>& mesh, std::uint32_t cell, const Point<D>& point) {
  Eigen::Matrix<double, D, D + 1> p;
  for (int k = 0; k <= D; ++k) p.col(k) = mesh.points[mesh.cells[cell].vertices[static_cast<std::size_t>(k)]] - point;
  if constexpr (D == 1) {
    return {p(0, 1), -p(0, 0)};
  } else if constexpr (D == 2) {
    const auto cross = [&](int a, int b) { return p(0, a) * p(1, b) - p(1, a) * p(0, b); };
    return {cross(1, 2), cross(2, 0), cross(0, 1)};
  } else {
    const Eigen::Vector3d of_01 = p.col(0).cross(p.col(1));
    const Eigen::Vector3d of_23 = p.col(2).cross(p.col(3));
    return {p.col(1).dot(of_23), -p.col(0).dot(of_23), p.col(3).dot(of_01), -p.col(2).dot(of_01)};
  }
}

template <int D>
SimplexPlace<D> place_in(std::uint32_t cell, Weights<D> weights) {
  double sum = 0.0;
  for (double& w : weights) sum += w = std::max(w, 0.0);
  if (!(sum > 0.0)) weights.fill(sum = 1.0);
  for (double& w : weights) w /= sum;
  return {cell, weights};
}

template <int D>
std::vector<Point<D>> centres_of(const SimplexMesh<D>& mesh) {
  std::vector<Point<D>> centres;
  centres.reserve(mesh.cells.size());
  for (const auto& cell : mesh.cells) {
    Point<D> sum = Point<D>::Zero();
    for (const auto v : cell.vertices) sum += mesh.points[v];
    centres.push_back(sum / (D + 1.0));
  }
  return centres;
}

// The widest side of the points' box.
template <int D>
std::uint32_t widest_axis(const std::vector<Point<D>>& points, const std::uint32_t* first, const std::uint32_t* last) {
  Point<D> low = points[*first];
  Point<D> high = low;
  for (const auto* k = first; k != last; ++k) {
    low = low.cwiseMin(points[*k]);
    high = high.cwiseMax(points[*k]);
  }
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  return static_cast<std::uint32_t>(axis);
}

}  // namespace

template <int D>
SimplexSearch<D>::SimplexSearch(const SimplexMesh<D>& mesh) : mesh_(mesh) {
  const auto centres = centres_of(mesh);
  std::vector<Index> cells(mesh.cells.size());
  std::iota(cells.begin(), cells.end(), 0U);
  add_node(centres, cells, 0, cells.size());
}

template <int D>
void SimplexSearch<D>::add_node(const std::vector<Point<D>>& centres, std::vector<Index>& cells, std::size_t first,
                                std::size_t last) {
  const std::size_t middle = first + (last - first) / 2;
  const std::size_t node = nodes_.size();
  nodes_.emplace_back();
  if (last - first <= leaf_cells) {
    nodes_[node].next = cells[middle];
    return;
  }
  const Index axis = widest_axis<D>(centres, cells.data() + first, cells.data() + last);
  const auto at = [&](std::size_t k) { return cells.begin() + static_cast<std::ptrdiff_t>(k); };
  std::nth_element(at(first), at(middle), at(last), [&](Index a, Index b) {
    const double of_a = centres[a][axis];
    const double of_b = centres[b][axis];
    return of_a != of_b ? of_a < of_b : a < b;
  });
  nodes_[node] = {centres[cells[middle]][axis], axis, 0};
  add_node(centres, cells, first, middle);
  nodes_[node].next = static_cast<Index>(nodes_.size());
  add_node(centres, cells, middle, last);
}

template <int D>
std::uint32_t SimplexSearch<D>::start(const Point<D>& point) const {
  Index node = 0;
  while (nodes_[node].axis != D) node = point[nodes_[node].axis] < nodes_[node].split ? node + 1 : nodes_[node].next;
  return nodes_[node].next;
}

template <int D>
SimplexPlace<D> SimplexSearch<D>::find(const Point<D>& point) const {
  Index cell = start(point);
  Index from = SimplexMesh<D>::none;
  for (int step = 0; step < most_steps; ++step) {
    const auto weights = volumes(mesh_, cell, point);
    std::size_t out = D + 1;
    double least = 0.0;
    for (std::size_t k = 0; k <= D; ++k) {
      if (!(weights[k] < least)) continue;
      // By rounding a face may seem to turn its back on both sides.
      if (const Index beyond = mesh_.cells[cell].neighbours[k]; beyond == from && beyond != SimplexMesh<D>::none)
        continue;
      least = weights[k];
      out = k;
    }
    if (out > D) return place_in<D>(cell, weights);
    from = cell;
    cell = mesh_.cells[cell].neighbours[out];
    if (cell == SimplexMesh<D>::none) return {};
  }
  return find_anywhere(point);
}

template <int D>
SimplexPlace<D> SimplexSearch<D>::find_anywhere(const Point<D>& point) const {
  constexpr double rounding = 1e-9;
  SimplexPlace<D> best;
  double most = -rounding;
  for (Index c = 0; c < mesh_.cells.size(); ++c) {
    const auto weights = volumes(mesh_, c, point);
    const double least = *std::min_element(weights.begin(), weights.end());
    const double inside = least / std::abs(std::accumulate(weights.begin(), weights.end(), 0.0));
    if (!(inside > most)) continue;
    most = inside;
    best = place_in<D>(c, weights);
  }
  return best;
}

template class SimplexSearch<1>;
template class SimplexSearch<2>;
template class SimplexSearch<3>;

}  // namespace lrcs
