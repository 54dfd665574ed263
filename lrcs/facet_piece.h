#pragma once
#include <algorithm>
#include <array>

#include "base/vec3.h"
#include "lrcs/layer_count.h"

namespace lrcs {

// A quarter of a facet, in the facet's coordinates (u, v): its corners are (u, v), (u + size, v), (u, v + size), or, of
// the one in the middle, (u + size, v + size), (u, v + size), (u + size, v).
struct FacetPiece {
  double u, v;
  bool inverted = false;

  static constexpr double size = 0.5;
  static constexpr double area = 0.5 * size * size;  // the facet's: 1/2
  static const std::array<FacetPiece, 4> quarters;

  // The piece as if it were the facet: rows of equal v stay rows, and what is left stays left.
  [[nodiscard]] LayerEdge within(const LayerEdge& edge) const {
    LayerEdge e = edge;
    const Eigen::Vector2d from = within(Eigen::Vector2d(edge.u0, edge.v0)),
                          to = within(Eigen::Vector2d(edge.u1, edge.v1));
    e.u0 = from.x(), e.v0 = from.y(), e.u1 = to.x(), e.v1 = to.y();
    return e;
  }
  [[nodiscard]] Eigen::Vector2d within(const Eigen::Vector2d& at) const {
    const double x = (at.x() - u) / size, y = (at.y() - v) / size;
    return inverted ? Eigen::Vector2d(x + y - 1.0, 1.0 - y) : Eigen::Vector2d(x, y);
  }
  // The way back.
  [[nodiscard]] Eigen::Vector2d on_facet(const Eigen::Vector2d& at) const {
    const double y = inverted ? 1.0 - at.y() : at.y(), x = inverted ? at.x() + 1.0 - y : at.x();
    return {u + size * x, v + size * y};
  }

  // A place of the piece: what lies outside is moved in, toward the middle of the corners it lies between.
  [[nodiscard]] Eigen::Vector2d nearest_within(const Eigen::Vector2d& at) const {
    const Eigen::Vector2d here = within(at);
    std::array<double, 3> weights{1.0 - here.x() - here.y(), here.x(), here.y()};
    for (double& w : weights) w = std::max(w, 0.0);
    const double sum = weights[0] + weights[1] + weights[2];
    return on_facet({weights[1] / sum, weights[2] / sum});
  }

  // With u and v in each other's place.
  [[nodiscard]] FacetPiece turned() const { return {v, u, inverted}; }
};

inline constexpr std::array<FacetPiece, 4> FacetPiece::quarters{
    {{0.0, 0.0}, {size, 0.0}, {0.0, size}, {0.0, 0.0, true}}};

}  // namespace lrcs
