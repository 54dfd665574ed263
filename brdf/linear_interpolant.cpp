#include "brdf/linear_interpolant.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "brdf/affine_frame.h"
#include "brdf/curve_order.h"
#include "brdf/hull_search.h"

namespace lrcs {
namespace {

constexpr double everywhere = std::numeric_limits<double>::infinity();

// One place only.
struct Single {};

template <int D>
struct Triangulated {
  explicit Triangulated(std::vector<Point<D>> points)
      : mesh(delaunay<D>(std::move(points))), search(mesh), hull(mesh) {}

  // The place, or that of the hull nearest to it; none farther away than `most`.
  [[nodiscard]] SimplexPlace<D> find(const Vec3& local, double most) const {
    const Point<D> point = local.head<D>();
    const SimplexPlace<D> found = search.find(point);
    return found.exists() ? found : hull.nearest(point, most);
  }

  SimplexMesh<D> mesh;
  SimplexSearch<D> search;
  HullSearch<D> hull;
};

// Held by pointer: the searches refer to their mesh.
template <int D>
using Held = std::unique_ptr<const Triangulated<D>>;
using Anyone = std::variant<Single, Held<1>, Held<2>, Held<3>>;

template <int D>
Held<D> triangulated(const std::vector<Vec3>& places, const AffineFrame& frame) {
  std::vector<Point<D>> points;
  points.reserve(places.size());
  for (const Vec3& place : places) points.push_back(frame.local(place).head<D>());
  return std::make_unique<const Triangulated<D>>(std::move(points));
}

Anyone triangulation_of(const std::vector<Vec3>& places, const AffineFrame& frame) {
  switch (frame.dimension) {
    case 0:
      return Single{};
    case 1:
      return triangulated<1>(places, frame);
    case 2:
      return triangulated<2>(places, frame);
    default:
      return triangulated<3>(places, frame);
  }
}

// Differences to the first value: where all are equal, so is the result.
template <int D>
double value_at(const SimplexMesh<D>& mesh, const SimplexPlace<D>& place, const std::vector<double>& values) {
  const auto& vertices = mesh.cells[place.cell].vertices;
  const double first = values[vertices[0]];
  double sum = first;
  double least = first;
  double most = first;
  for (std::size_t k = 1; k <= D; ++k) {
    const double value = values[vertices[k]];
    sum += place.weights[k] * (value - first);
    least = std::min(least, value);
    most = std::max(most, value);
  }
  return std::clamp(sum, least, most);
}

constexpr double rounding_of_weights = 1e-9;  // of a place on a face, for the vertex opposite

// Of the vertices that have a say.
template <int D>
LinearInterpolant::Span span_at(const SimplexMesh<D>& mesh, const SimplexPlace<D>& place,
                                const std::vector<double>& values) {
  LinearInterpolant::Span span{std::numeric_limits<double>::infinity(), 0.0};
  for (std::size_t k = 0; k <= D; ++k) {
    if (place.weights[k] <= rounding_of_weights) continue;
    const double value = values[mesh.cells[place.cell].vertices[k]];
    span = {std::min(span.least, value), std::max(span.largest, value)};
  }
  return span;
}

// The volume (times D!) spanned by D edges.
template <int D>
double volume(const std::array<Point<D>, D>& edges) {
  if constexpr (D == 1)
    return edges[0].x();
  else if constexpr (D == 2)
    return edges[0].x() * edges[1].y() - edges[0].y() * edges[1].x();
  else
    return edges[0].dot(edges[1].cross(edges[2]));
}

// The gradient of the weight of one vertex is at most the product of the other edges over the volume.
template <int D>
double steepness_at(const SimplexMesh<D>& mesh, std::uint32_t cell, const std::vector<double>& values) {
  const auto& vertices = mesh.cells[cell].vertices;
  std::array<Point<D>, D> edges;
  for (std::size_t k = 0; k < D; ++k) edges[k] = mesh.points[vertices[k + 1]] - mesh.points[vertices[0]];
  double most = 0.0;
  for (std::size_t k = 0; k < D; ++k) {
    double others = 1.0;
    for (std::size_t j = 0; j < D; ++j)
      if (j != k) others *= edges[j].norm();
    most += std::abs(values[vertices[k + 1]] - values[vertices[0]]) * others;
  }
  return most > 0.0 ? most / std::max(std::abs(volume<D>(edges)), 1e-300) : 0.0;
}

// Perpendicular to the face of a cell opposite its vertex k, away from that vertex; of any length.
template <int D>
Point<D> outward(const SimplexMesh<D>& mesh, const typename SimplexMesh<D>::Cell& cell, std::size_t k) {
  const auto corner = [&](std::size_t j) { return mesh.points[cell.vertices[(k + j) % (D + 1)]]; };
  Point<D> normal;
  if constexpr (D == 1) {
    normal.setOnes();
  } else if constexpr (D == 2) {
    const Point<2> edge = corner(2) - corner(1);
    normal = {-edge.y(), edge.x()};
  } else {
    normal = (corner(2) - corner(1)).cross(corner(3) - corner(1));
  }
  return normal.dot(corner(1) - corner(0)) < 0.0 ? Point<D>(-normal) : normal;
}

// Numbers of points, each once.
template <int D>
std::vector<std::uint32_t> corners_toward_folds(const SimplexMesh<D>& mesh, const AffineFrame& frame) {
  constexpr double flat = 1e-9;
  std::vector<std::uint32_t> corners;
  for (const auto& cell : mesh.cells)
    for (std::size_t k = 0; k <= D; ++k) {
      if (cell.neighbours[k] != SimplexMesh<D>::none) continue;
      Vec3 normal = Vec3::Zero();
      const Point<D> local = outward<D>(mesh, cell, k);
      for (int axis = 0; axis < D; ++axis) normal += local[axis] * frame.axes.row(axis).transpose();
      if (std::min(normal.y(), normal.z()) >= -flat * normal.norm()) continue;
      for (std::size_t j = 1; j <= D; ++j) corners.push_back(cell.vertices[(k + j) % (D + 1)]);
    }
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

}  // namespace

struct LinearInterpolant::Parts {
  AffineFrame frame;
  std::vector<double> values;
  double tolerance;
  Anyone triangulation;

  // What `of_simplex(mesh, where)` says of the place, or of that nearest to it; of a single sample: `of_one`. None
  // where the triangulation is farther away than `most`.
  template <class Answer, class OfSimplex>
  [[nodiscard]] std::optional<Answer> ask(const Vec3& place, double most, const Answer& of_one,
                                          const OfSimplex& of_simplex) const {
    const Vec3 local = frame.local(place);
    double off2 = 0.0;
    for (int k = frame.dimension; k < 3; ++k) off2 += local[k] * local[k];
    if (std::sqrt(off2) > most) return std::nullopt;
    const auto within = [&]<class Held>(const Held& in) -> std::optional<Answer> {
      if constexpr (requires { in->mesh; }) {
        const auto found = in->find(local, most);
        return found.exists() ? std::optional<Answer>(of_simplex(in->mesh, found)) : std::nullopt;
      } else {
        return of_one;
      }
    };
    return std::visit(within, triangulation);
  }

  [[nodiscard]] std::optional<double> value(const Vec3& place, double most) const {
    return ask(place, most, values.front(),
               [&](const auto& mesh, const auto& found) { return value_at(mesh, found, values); });
  }
};

LinearInterpolant::LinearInterpolant(const std::vector<Vec3>& places, const std::vector<double>& values,
                                     double tolerance) {
  std::vector<Vec3> ordered_places;
  std::vector<double> ordered_values;
  for (const std::uint32_t k : curve_order<3>(places)) {
    ordered_places.push_back(places[k]);
    ordered_values.push_back(values[k]);
  }
  const AffineFrame frame = affine_frame(ordered_places, tolerance);
  parts_ = std::make_shared<const Parts>(
      Parts{frame, std::move(ordered_values), tolerance, triangulation_of(ordered_places, frame)});
}

std::optional<double> LinearInterpolant::at(const Vec3& place) const {
  return parts_->value(place, parts_->tolerance);
}

double LinearInterpolant::nearest(const Vec3& place) const {
  return parts_->value(place, everywhere).value();
}

double LinearInterpolant::steepness(const Vec3& place) const {
  const auto of_simplex = [&](const auto& mesh, const auto& found) {
    return steepness_at(mesh, found.cell, parts_->values);
  };
  return parts_->ask(place, everywhere, 0.0, of_simplex).value();
}

std::optional<LinearInterpolant::Span> LinearInterpolant::span(const Vec3& place) const {
  const double one = parts_->values.front();
  return parts_->ask(place, parts_->tolerance, Span{one, one},
                     [&](const auto& mesh, const auto& found) { return span_at(mesh, found, parts_->values); });
}

std::vector<LinearInterpolant::Corner> LinearInterpolant::corners_toward_folds() const {
  std::vector<Corner> corners;
  std::visit(
      [&](const auto& in) {
        if constexpr (requires { in->mesh; })
          for (const std::uint32_t k : lrcs::corners_toward_folds(in->mesh, parts_->frame)) {
            Vec3 place = parts_->frame.origin;
            for (int axis = 0; axis < parts_->frame.dimension; ++axis)
              place += in->mesh.points[k][axis] * parts_->frame.axes.row(axis).transpose();
            corners.push_back({place, parts_->values[k]});
          }
      },
      parts_->triangulation);
  return corners;
}

bool LinearInterpolant::is_level(const Vec3& place) const {
  const Vec3 local = parts_->frame.local(place);
  for (int k = parts_->frame.dimension; k < 3; ++k)
    if (std::abs(local[k]) > parts_->tolerance) return false;
  return true;
}

int LinearInterpolant::dimension() const {
  return parts_->frame.dimension;
}

std::size_t LinearInterpolant::simplices() const {
  return std::visit(
      [](const auto& in) -> std::size_t {
        if constexpr (requires { in->mesh; })
          return in->mesh.cells.size();
        else
          return 0;
      },
      parts_->triangulation);
}

}  // namespace lrcs
