#include "brdf/hull_search.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace lrcs {
namespace {

constexpr std::size_t leaf_faces = 4;

// The nearest point of a face, by weights of its corners.
std::array<double, 1> nearest_weights(const std::array<Point<1>, 1>& /*corners*/, const Point<1>& /*point*/) {
  return {1.0};
}

template <int D>
double share_along(const Point<D>& a, const Point<D>& b, const Point<D>& point) {
  const Point<D> edge = b - a;
  return std::clamp(edge.dot(point - a) / edge.squaredNorm(), 0.0, 1.0);
}

std::array<double, 2> nearest_weights(const std::array<Point<2>, 2>& corners, const Point<2>& point) {
  const double t = share_along<2>(corners[0], corners[1], point);
  return {1.0 - t, t};
}

std::array<double, 3> nearest_weights(const std::array<Point<3>, 3>& corners, const Point<3>& point) {
  const Point<3> normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  std::array<double, 3> inside{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Point<3>& a = corners[(k + 1) % 3];
    inside[k] = (corners[(k + 2) % 3] - a).cross(point - a).dot(normal) / normal.squaredNorm();
  }
  if (inside[0] >= 0.0 && inside[1] >= 0.0 && inside[2] >= 0.0) return inside;
  std::array<double, 3> best{};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const double t = share_along<3>(corners[k], corners[next], point);
    const double apart = (corners[k] + t * (corners[next] - corners[k]) - point).squaredNorm();
    if (!(apart < least)) continue;
    least = apart;
    best = {};
    best[k] = 1.0 - t;
    best[next] = t;
  }
  return best;
}

template <int D>
double distance_to_box(const Point<D>& low, const Point<D>& high, const Point<D>& point) {
  return (low - point).cwiseMax(point - high).cwiseMax(0.0).norm();
}

}  // namespace

template <int D>
HullSearch<D>::HullSearch(const SimplexMesh<D>& mesh) : mesh_(mesh) {
  for (Index c = 0; c < mesh.cells.size(); ++c)
    for (std::size_t k = 0; k <= D; ++k) {
      if (mesh.neighbours[c][k] != SimplexMesh<D>::none) continue;
      Face& face = faces_.emplace_back();
      face.cell = c;
      for (std::size_t j = 0; j < D; ++j) face.corners[j] = static_cast<Index>(j < k ? j : j + 1);
    }
  add_node(0, faces_.size());
}

template <int D>
const Point<D>& HullSearch<D>::corner(const Face& face, std::size_t k) const {
  return mesh_.points[mesh_.cells[face.cell][face.corners[k]]];
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
typename HullSearch<D>::Nearest HullSearch<D>::nearest_of(const Face& face, const Point<D>& point) const {
  std::array<Point<D>, D> corners;
  for (std::size_t k = 0; k < D; ++k) corners[k] = corner(face, k);
  const auto weights = nearest_weights(corners, point);
  Nearest nearest;
  nearest.place.cell = face.cell;
  Point<D> place = Point<D>::Zero();
  for (std::size_t k = 0; k < D; ++k) {
    nearest.place.weights[face.corners[k]] = weights[k];
    place += weights[k] * corners[k];
  }
  nearest.distance = (place - point).norm();
  return nearest;
}

template <int D>
void HullSearch<D>::search(Index node, const Point<D>& point, Nearest& best) const {
  const Node& box = nodes_[node];
  for (Index f = box.next; f < box.next + box.faces; ++f) {
    const Nearest here = nearest_of(faces_[f], point);
    if (here.distance < best.distance) best = here;
  }
  if (box.faces > 0) return;
  const auto apart = [&](Index child) { return distance_to_box<D>(nodes_[child].low, nodes_[child].high, point); };
  std::array<Index, 2> children{node + 1, box.next};
  std::array<double, 2> distances{apart(children[0]), apart(children[1])};
  if (distances[1] < distances[0]) {
    std::swap(children[0], children[1]);
    std::swap(distances[0], distances[1]);
  }
  for (std::size_t k = 0; k < 2; ++k)
    if (distances[k] < best.distance) search(children[k], point, best);
}

template <int D>
typename HullSearch<D>::Nearest HullSearch<D>::nearest(const Point<D>& point) const {
  Nearest best;
  best.distance = std::numeric_limits<double>::infinity();
  search(0, point, best);
  return best;
}

template class HullSearch<1>;
template class HullSearch<2>;
template class HullSearch<3>;

}  // namespace lrcs
