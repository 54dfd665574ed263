#include "brdf/hull_search.h"

#include <algorithm>
#include <utility>

namespace lrcs {
namespace {

constexpr std::size_t leaf_faces = 2;

// The nearest point of a face, by weights of its corners.
std::array<double, 1> nearest_weights(const std::array<Point<1>, 1>& /*corners*/, const Point<1>& /*point*/) {
  return {1.0};
}

std::array<double, 2> nearest_weights(const std::array<Point<2>, 2>& corners, const Point<2>& point) {
  const Point<2> edge = corners[1] - corners[0];
  const double t = std::clamp(edge.dot(point - corners[0]) / edge.squaredNorm(), 0.0, 1.0);
  return {1.0 - t, t};
}

// source: C. Ericson, Real-Time Collision Detection, 2005, section 5.1.5.
std::array<double, 3> nearest_weights(const std::array<Point<3>, 3>& corners, const Point<3>& point) {
  const auto& [a, b, c] = corners;
  const Point<3> ab = b - a;
  const Point<3> ac = c - a;
  const Point<3> ap = point - a;
  const double b_a = ab.dot(ap);
  const double c_a = ac.dot(ap);
  if (b_a <= 0.0 && c_a <= 0.0) return {1.0, 0.0, 0.0};
  const Point<3> bp = point - b;
  const double b_b = ab.dot(bp);
  const double c_b = ac.dot(bp);
  if (b_b >= 0.0 && c_b <= b_b) return {0.0, 1.0, 0.0};
  const Point<3> cp = point - c;
  const double b_c = ab.dot(cp);
  const double c_c = ac.dot(cp);
  if (c_c >= 0.0 && b_c <= c_c) return {0.0, 0.0, 1.0};
  const auto along = [](double from, double to) { return from / (from + to); };
  const double of_c = b_a * c_b - b_b * c_a;
  if (of_c <= 0.0 && b_a >= 0.0 && b_b <= 0.0) {
    const double t = along(b_a, -b_b);
    return {1.0 - t, t, 0.0};
  }
  const double of_b = b_c * c_a - b_a * c_c;
  if (of_b <= 0.0 && c_a >= 0.0 && c_c <= 0.0) {
    const double t = along(c_a, -c_c);
    return {1.0 - t, 0.0, t};
  }
  const double of_a = b_b * c_c - b_c * c_b;
  if (of_a <= 0.0 && c_b - b_b >= 0.0 && b_c - c_c >= 0.0) {
    const double t = along(c_b - b_b, b_c - c_c);
    return {0.0, 1.0 - t, t};
  }
  const double all = of_a + of_b + of_c;
  return {of_a / all, of_b / all, of_c / all};
}

template <int D>
double distance2_to_box(const Point<D>& low, const Point<D>& high, const Point<D>& point) {
  return (low - point).cwiseMax(point - high).cwiseMax(0.0).squaredNorm();
}

}  // namespace

template <int D>
HullSearch<D>::HullSearch(const SimplexMesh<D>& mesh) : mesh_(mesh) {
  for (Index c = 0; c < mesh.cells.size(); ++c)
    for (std::size_t k = 0; k <= D; ++k) {
      if (mesh.cells[c].neighbours[k] != SimplexMesh<D>::none) continue;
      Face& face = faces_.emplace_back();
      face.cell = c;
      for (std::size_t j = 0; j < D; ++j) face.corners[j] = static_cast<Index>(j < k ? j : j + 1);
    }
  add_node(0, faces_.size());
}

template <int D>
const Point<D>& HullSearch<D>::corner(const Face& face, std::size_t k) const {
  return mesh_.points[mesh_.cells[face.cell].vertices[face.corners[k]]];
}

template <int D>
void HullSearch<D>::add_node(std::size_t first, std::size_t last) {
  Node box;
  box.low = box.high = corner(faces_[first], 0);
  for (std::size_t f = first; f < last; ++f)
    for (std::size_t k = 0; k < D; ++k) {
      box.low = box.low.cwiseMin(corner(faces_[f], k));
      box.high = box.high.cwiseMax(corner(faces_[f], k));
    }
  const std::size_t node = nodes_.size();
  nodes_.push_back(box);
  if (last - first <= leaf_faces) {
    nodes_[node].next = static_cast<Index>(first);
    nodes_[node].faces = static_cast<Index>(last - first);
    return;
  }
  Eigen::Index axis = 0;
  (box.high - box.low).maxCoeff(&axis);
  const std::size_t middle = first + (last - first) / 2;
  const auto at = [&](std::size_t k) { return faces_.begin() + static_cast<std::ptrdiff_t>(k); };
  const auto centre = [&](const Face& face) {
    double sum = 0.0;
    for (std::size_t k = 0; k < D; ++k) sum += corner(face, k)[axis];
    return sum;
  };
  std::nth_element(at(first), at(middle), at(last), [&](const Face& a, const Face& b) {
    const double of_a = centre(a);
    const double of_b = centre(b);
    return of_a != of_b ? of_a < of_b : a.cell < b.cell;
  });
  add_node(first, middle);
  nodes_[node].next = static_cast<Index>(nodes_.size());
  add_node(middle, last);
}

template <int D>
void HullSearch<D>::try_face(const Face& face, const Point<D>& point, Nearest& best) const {
  std::array<Point<D>, D> corners;
  for (std::size_t k = 0; k < D; ++k) corners[k] = corner(face, k);
  const auto weights = nearest_weights(corners, point);
  Point<D> apart = -point;
  for (std::size_t k = 0; k < D; ++k) apart += weights[k] * corners[k];
  if (!(apart.squaredNorm() < best.distance2)) return;
  best.distance2 = apart.squaredNorm();
  best.place = {face.cell, {}};
  for (std::size_t k = 0; k < D; ++k) best.place.weights[face.corners[k]] = weights[k];
}

template <int D>
void HullSearch<D>::search(Index node, const Point<D>& point, Nearest& best) const {
  const Node& box = nodes_[node];
  for (Index f = box.next; f < box.next + box.faces; ++f) try_face(faces_[f], point, best);
  if (box.faces > 0) return;
  const auto apart = [&](Index child) { return distance2_to_box<D>(nodes_[child].low, nodes_[child].high, point); };
  std::array<Index, 2> children{node + 1, box.next};
  std::array<double, 2> distances{apart(children[0]), apart(children[1])};
  if (distances[1] < distances[0]) {
    std::swap(children[0], children[1]);
    std::swap(distances[0], distances[1]);
  }
  for (std::size_t k = 0; k < 2; ++k)
    if (distances[k] < best.distance2) search(children[k], point, best);
}

template <int D>
SimplexPlace<D> HullSearch<D>::nearest(const Point<D>& point, double most) const {
  Nearest best{{}, most * most};
  search(0, point, best);
  return best.place;
}

template class HullSearch<1>;
template class HullSearch<2>;
template class HullSearch<3>;

}  // namespace lrcs
