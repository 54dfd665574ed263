#include "mesh/polygon_cut.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cmath>
#include <map>
#include <utility>

namespace lrcs {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point2 = Kernel::Point_2;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;
using Facets = std::vector<std::array<std::uint32_t, 3>>;
using Polygon = std::span<const std::uint32_t>;

// Twice the polygon's area times its normal (Newell), about its first corner.
Vec3 area_vector(const std::vector<Vec3>& positions, Polygon corners) {
  Vec3 sum = Vec3::Zero();
  const Vec3& origin = positions[corners[0]];
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    sum += (positions[corners[k]] - origin).cross(positions[corners[k + 1]] - origin);
  return sum;
}

// The corners in the coordinate plane nearest to the polygon's, where they run counter-clockwise.
std::vector<Point2> projected(const std::vector<Vec3>& positions, Polygon corners) {
  const Vec3 normal = area_vector(positions, corners);
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  Eigen::Index u = (axis + 1) % 3;
  Eigen::Index v = (axis + 2) % 3;
  if (normal[axis] < 0.0) std::swap(u, v);
  std::vector<Point2> points;
  points.reserve(corners.size());
  for (const std::uint32_t corner : corners) points.emplace_back(positions[corner][u], positions[corner][v]);
  return points;
}

// Files give coordinates to six or seven digits: a corner on a straight side then turns either way by so much [rad].
constexpr double straight = 0x1p-16;

bool turns_right(const Point2& a, const Point2& b, const Point2& c) {
  const auto u = b - a;
  const auto v = c - b;
  return u.x() * v.y() - u.y() * v.x() < -straight * std::sqrt(u.squared_length() * v.squared_length());
}

// No corner turns right, and no triangle of the fan does (which a star's would).
bool is_convex(const std::vector<Point2>& points) {
  const std::size_t n = points.size();
  for (std::size_t k = 0; k < n; ++k) {
    if (turns_right(points[k], points[(k + 1) % n], points[(k + 2) % n])) return false;
  }
  for (std::size_t k = 1; k + 1 < n; ++k) {
    if (turns_right(points[0], points[k], points[k + 1])) return false;
  }
  return true;
}

void append_fan(Polygon corners, Facets& facets) {
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) facets.push_back({corners[0], corners[k], corners[k + 1]});
}

using VertexPair = std::pair<Triangulation::Vertex_handle, Triangulation::Vertex_handle>;

VertexPair ordered(Triangulation::Vertex_handle a, Triangulation::Vertex_handle b) {
  return a < b ? VertexPair(a, b) : VertexPair(b, a);
}

// The polygon's boundary in a triangulation, and how often it runs along each edge: twice along the bridge to a hole.
class Boundary {
 public:
  // Throws CGAL's exception where the polygon crosses itself.
  Boundary(const std::vector<Point2>& points, Polygon corners) {
    const std::vector<Triangulation::Vertex_handle> vertices = insert(points, corners);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto a = vertices[k];
      const auto b = vertices[(k + 1) % points.size()];
      if (a == b) continue;
      triangulation_.insert_constraint(a, b);
      ++passes_[ordered(a, b)];
    }
  }

  [[nodiscard]] const Triangulation& triangulation() const { return triangulation_; }
  [[nodiscard]] bool separates(const Triangulation::Edge& edge) const {
    if (!triangulation_.is_constrained(edge)) return false;
    const auto entry = passes_.find(ordered(edge.first->vertex(Triangulation::cw(edge.second)),
                                            edge.first->vertex(Triangulation::ccw(edge.second))));
    return entry == passes_.end() || entry->second % 2 == 1;
  }

 private:
  std::vector<Triangulation::Vertex_handle> insert(const std::vector<Point2>& points, Polygon corners) {
    std::vector<Triangulation::Vertex_handle> vertices;
    vertices.reserve(points.size());
    Triangulation::Face_handle near;  // the next corner is not far
    for (std::size_t k = 0; k < points.size(); ++k) {
      const std::size_t known = triangulation_.number_of_vertices();
      vertices.push_back(triangulation_.insert(points[k], near));
      near = vertices.back()->face();
      if (triangulation_.number_of_vertices() > known) vertices.back()->info() = corners[k];
    }
    return vertices;
  }

  Triangulation triangulation_;
  std::map<VertexPair, int> passes_;
};

// The triangles that an odd number of boundary crossings divides from infinity.
void append_inside(const Boundary& boundary, Facets& facets) {
  const Triangulation& t = boundary.triangulation();
  std::map<Triangulation::Face_handle, bool> inside;
  std::vector<Triangulation::Face_handle> front{t.infinite_face()};
  inside[t.infinite_face()] = false;
  while (!front.empty()) {
    const auto face = front.back();
    front.pop_back();
    for (int k = 0; k < 3; ++k) {
      const auto neighbour = face->neighbor(k);
      const auto [entry, is_new] = inside.try_emplace(neighbour, inside[face] != boundary.separates({face, k}));
      if (is_new) front.push_back(neighbour);
    }
  }
  for (const auto face : t.finite_face_handles()) {
    if (inside[face]) facets.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  }
}

}  // namespace

void cut_polygon(const std::vector<Vec3>& positions, std::span<const std::uint32_t> corners, Facets& facets) {
  if (corners.size() == 3) return append_fan(corners, facets);
  const std::vector<Point2> points = projected(positions, corners);
  if (is_convex(points)) return append_fan(corners, facets);
  const std::size_t before = facets.size();
  try {
    append_inside(Boundary(points, corners), facets);
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    facets.resize(before);
  }
  if (facets.size() == before) append_fan(corners, facets);
}

}  // namespace lrcs
