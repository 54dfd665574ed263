#pragma once
#include <array>

#include "base/vec3.h"
#include "lrcs/layer_count.h"

namespace lrcs {

// A triangle that a facet falls into when it is quartered, and quartered again, in the facet's coordinates (u, v): its
// corners are (u, v), (u + size, v), (u, v + size), or, inverted, (u + size, v + size), (u, v + size), (u + size, v).
struct FacetPiece {
  double u = 0.0, v = 0.0, size = 1.0;
  bool inverted = false;

  // Of the unit triangle's, 1/2.
  [[nodiscard]] double area() const { return 0.5 * size * size; }

  [[nodiscard]] std::array<FacetPiece, 4> quarters() const {
    const double half = 0.5 * size, own = inverted ? half : 0.0;  // the corner quarter and the one that lies turned
    return {{{u + half, v, half, inverted},
             {u, v + half, half, inverted},
             {u + own, v + own, half, inverted},
             {u + own, v + own, half, !inverted}}};
  }

  // Coordinates in the piece, as if it were the facet: rows of equal v stay rows, and what is left stays left.
  [[nodiscard]] Eigen::Vector2d within(const Eigen::Vector2d& at) const {
    const double x = (at.x() - u) / size, y = (at.y() - v) / size;
    return inverted ? Eigen::Vector2d(x + y - 1.0, 1.0 - y) : Eigen::Vector2d(x, y);
  }
  [[nodiscard]] LayerEdge within(const LayerEdge& edge) const {
    LayerEdge e = edge;
    const Eigen::Vector2d from = within(Eigen::Vector2d(edge.u0, edge.v0)),
                          to = within(Eigen::Vector2d(edge.u1, edge.v1));
    e.u0 = from.x(), e.v0 = from.y(), e.u1 = to.x(), e.v1 = to.y();
    return e;
  }
  // The way back.
  [[nodiscard]] Eigen::Vector2d on_facet(const Eigen::Vector2d& at) const { return origin() + axes() * at; }
  [[nodiscard]] AreaMoments on_facet(const AreaMoments& within) const {
    const Eigen::Matrix2d axes = this->axes();
    const Eigen::Vector2d first = axes * within.first, origin = this->origin();
    const Eigen::Matrix2d across = first * origin.transpose();
    const double scale = size * size;
    return {scale * within.area, scale * (first + within.area * origin),
            scale * (axes * within.second * axes.transpose() + across + across.transpose() +
                     within.area * origin * origin.transpose())};
  }

  // On the facet, one a column.
  [[nodiscard]] Eigen::Matrix<double, 2, 3> corners() const {
    return (axes() * (Eigen::Matrix<double, 2, 3>() << 0.0, 1.0, 0.0, 0.0, 0.0, 1.0).finished()).colwise() + origin();
  }

  // With u and v in each other's place.
  [[nodiscard]] FacetPiece swapped() const { return {v, u, size, inverted}; }

 private:
  [[nodiscard]] Eigen::Vector2d origin() const { return {u, inverted ? v + size : v}; }
  [[nodiscard]] Eigen::Matrix2d axes() const {
    return size * (Eigen::Matrix2d() << 1.0, inverted ? 1.0 : 0.0, 0.0, inverted ? -1.0 : 1.0).finished();
  }
};

}  // namespace lrcs
