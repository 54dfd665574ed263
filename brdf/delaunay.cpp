#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "brdf/curve_order.h"
#include "brdf/simplex_mesh.h"

namespace lrcs {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Index = std::uint32_t;

// What CGAL calls things in D dimensions.
template <int D>
struct Names;

template <>
struct Names<2> {
  using Vertex = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
  using Cell = CGAL::Triangulation_face_base_with_info_2<Index, Kernel>;
  using Triangulation = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex, Cell>>;
  using Handle = Triangulation::Face_handle;
  static Kernel::Point_2 point(const Point<2>& p) { return {p.x(), p.y()}; }
  static auto cells(const Triangulation& t) { return t.finite_face_handles(); }
};

template <>
struct Names<3> {
  using Vertex = CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>;
  using Cell =
      CGAL::Triangulation_cell_base_with_info_3<Index, Kernel, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
  using Triangulation = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex, Cell>>;
  using Handle = Triangulation::Cell_handle;
  static Kernel::Point_3 point(const Point<3>& p) { return {p.x(), p.y(), p.z()}; }
  static auto cells(const Triangulation& t) { return t.finite_cell_handles(); }
};

template <int D>
typename Names<D>::Triangulation triangulation_of(const std::vector<Point<D>>& points) {
  std::vector<std::pair<decltype(Names<D>::point(points.front())), Index>> numbered;
  numbered.reserve(points.size());
  for (const Point<D>& p : points) numbered.emplace_back(Names<D>::point(p), static_cast<Index>(numbered.size()));
  return typename Names<D>::Triangulation(numbered.begin(), numbered.end());
}

// The cells in the order of their centres along a curve; each knows its number.
template <int D>
std::vector<typename Names<D>::Handle> ordered_cells(const typename Names<D>::Triangulation& triangulation,
                                                     const std::vector<Point<D>>& points) {
  std::vector<typename Names<D>::Handle> found;
  std::vector<Point<D>> centres;
  for (const auto cell : Names<D>::cells(triangulation)) {
    found.push_back(cell);
    Point<D> sum = Point<D>::Zero();
    for (int k = 0; k <= D; ++k) sum += points[cell->vertex(k)->info()];
    centres.push_back(sum);
  }
  std::vector<typename Names<D>::Handle> ordered;
  ordered.reserve(found.size());
  for (const Index c : curve_order<D>(centres)) {
    found[c]->info() = static_cast<Index>(ordered.size());
    ordered.push_back(found[c]);
  }
  return ordered;
}

template <int D>
SimplexMesh<D> mesh_of(std::vector<Point<D>> points) {
  SimplexMesh<D> mesh;
  const auto triangulation = triangulation_of<D>(points);
  mesh.points = std::move(points);
  if (triangulation.dimension() < D) return mesh;
  const auto handles = ordered_cells<D>(triangulation, mesh.points);
  mesh.cells.resize(handles.size());
  for (std::size_t c = 0; c < handles.size(); ++c)
    for (int k = 0; k <= D; ++k) {
      const auto beyond = handles[c]->neighbor(k);
      const auto at = static_cast<std::size_t>(k);
      mesh.cells[c].vertices[at] = handles[c]->vertex(k)->info();
      mesh.cells[c].neighbours[at] = triangulation.is_infinite(beyond) ? SimplexMesh<D>::none : beyond->info();
    }
  return mesh;
}

}  // namespace

template <>
SimplexMesh<1> delaunay<1>(std::vector<Point<1>> points) {
  SimplexMesh<1> mesh;
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return points[a].x() < points[b].x(); });
  for (Index c = 0; c + 1 < order.size(); ++c) {
    const Index up = c + 2 < order.size() ? c + 1 : SimplexMesh<1>::none;
    const Index down = c > 0 ? c - 1 : SimplexMesh<1>::none;
    mesh.cells.push_back({{order[c], order[c + 1]}, {up, down}});
  }
  mesh.points = std::move(points);
  return mesh;
}

template <>
SimplexMesh<2> delaunay<2>(std::vector<Point<2>> points) {
  return mesh_of<2>(std::move(points));
}

template <>
SimplexMesh<3> delaunay<3>(std::vector<Point<3>> points) {
  return mesh_of<3>(std::move(points));
}

}  // namespace lrcs
