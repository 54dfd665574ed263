#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace lrcs {

template <int D>
using Point = Eigen::Matrix<double, D, 1>;

// Points of D dimensions, joined to simplices (segments, triangles, tetrahedra) that fill their convex hull.
// laws: the simplices are positively oriented, det(p1 - p0, ..., pD - p0) > 0; each vertex is a point, each point a
//   vertex.
template <int D>
struct SimplexMesh {
  using Index = std::uint32_t;
  static constexpr Index none = std::numeric_limits<Index>::max();

  struct Cell {
    std::array<Index, D + 1> vertices{};
    std::array<Index, D + 1> neighbours{};  // [k]: across the face opposite vertex k; none: the hull
  };
  std::vector<Point<D>> points;
  std::vector<Cell> cells;  // those near in space are near in number
};

// Delaunay's: no point lies inside the sphere about a simplex.
// domain: points differ, and are not all in one point, line or plane of fewer dimensions than D; else no cells, or
//   cells that leave out points. At most 2^32 - 2 cells.
// laws: the same mesh for the same points. Compiled for D = 1, 2, 3.
template <int D>
[[nodiscard]] SimplexMesh<D> delaunay(std::vector<Point<D>> points);

}  // namespace lrcs
