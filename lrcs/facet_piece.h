#pragma once
#include <algorithm>
#include <array>

#include "base/vec3.h"
#include "lrcs/layer_count.h"

namespace lrcs {

// A triangle that a facet falls into when it is quartered, and quartered again, in the facet's coordinates (u, v): its
// corners are (u, v), (u + size, v), (u, v + size), or, inverted, (u + size, v + size), (u, v + size), (u + size, v).
struct FacetPiece {
  double u = 0.0, v = 0.0, size = 1.0;
  bool inverted = false;

  // [1] of the unit triangle's, 1/2.
  [[nodiscard]] double area() const { return 0.5 * size * size; }

  [[nodiscard]] std::array<FacetPiece, 4> quarters() const {
    const double half = 0.5 * size, own = inverted ? half : 0.0;  // the corner quarter and the one that lies turned
    return {{{u + half, v, half, inverted},
             {u, v + half, half, inverted},
             {u + own, v + own, half, inverted},
             {u + own, v + own, half, !inverted}}};
  }

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
  [[nodiscard]] FacetPiece turned() const { return {v, u, size, inverted}; }
};

}  // namespace lrcs
