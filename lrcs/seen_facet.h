#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "lrcs/view_outline.h"

namespace lrcs {

// A facet in the coordinates of a view, as far as its doubles tell. error: ViewOutline::rounding() in each coordinate.
struct SeenFacet {
  std::array<double, 3> x, y, z;    // of the corners
  double left, right, bottom, top;  // its box across the view
  double far, near;                 // from and to depth z, rounding included

  SeenFacet(const ViewOutline& view, const std::array<std::uint32_t, 3>& ids)
      : x{view.x()[ids[0]], view.x()[ids[1]], view.x()[ids[2]]},
        y{view.y()[ids[0]], view.y()[ids[1]], view.y()[ids[2]]},
        z{view.z()[ids[0]], view.z()[ids[1]], view.z()[ids[2]]},
        left(std::min({x[0], x[1], x[2]})),
        right(std::max({x[0], x[1], x[2]})),
        bottom(std::min({y[0], y[1], y[2]})),
        top(std::max({y[0], y[1], y[2]})),
        far(std::min({z[0], z[1], z[2]}) - view.rounding()),
        near(std::max({z[0], z[1], z[2]}) + view.rounding()) {}

  // Twice its area across the view.
  [[nodiscard]] double area() const { return (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]); }
  // The sizes of the two sides at corner 0, together.
  [[nodiscard]] double sides() const {
    return std::abs(x[1] - x[0]) + std::abs(y[1] - y[0]) + std::abs(x[2] - x[0]) + std::abs(y[2] - y[0]);
  }

  // How its own coordinates u and v (FacetFrame) change with x and y.
  struct OwnCoordinates {
    double u_x, u_y, v_x, v_y;
  };
  [[nodiscard]] OwnCoordinates own_coordinates() const {
    const double twice = area();
    return {(y[2] - y[0]) / twice, -(x[2] - x[0]) / twice, -(y[1] - y[0]) / twice, (x[1] - x[0]) / twice};
  }
};

}  // namespace lrcs
