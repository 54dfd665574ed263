#include "view/parallel_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lrcs {
namespace {

// The part of `up` across `direction`, as a unit vector; of another axis where they (nearly) run along each other.
Vec3 across(const Vec3& up, const Vec3& direction) {
  constexpr double nearly_along = 1e-3;  // [rad]
  const Vec3 rest = up - up.dot(direction) * direction;
  if (rest.norm() > nearly_along * up.norm()) return rest.normalized();
  const Vec3 other = std::abs(direction.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitZ();
  return (other - other.dot(direction) * direction).normalized();
}

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void take(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] double middle() const { return 0.5 * (low + high); }
  [[nodiscard]] double span() const { return high - low; }
};

}  // namespace

Point ParallelView::step(const Vec3& direction) const {
  return {pixels_a_metre * right.dot(direction), pixels_a_metre * up.dot(direction)};
}

Point ParallelView::at(const Vec3& p) const {
  const Point from_middle = step(p - centre);
  return {0.5 * (box.low.x + box.high.x) + from_middle.x, 0.5 * (box.low.y + box.high.y) + from_middle.y};
}

ParallelView view_of(const FacetMesh& mesh, const Vec3& toward_viewer, const Vec3& up, const Box& box) {
  ParallelView view;
  view.box = box;
  view.backward = toward_viewer.normalized();
  view.up = across(up, view.backward);
  view.right = view.up.cross(view.backward);
  Range x;
  Range y;
  Range z;
  for (const auto& facet : mesh.facets) {
    for (const std::uint32_t vertex : facet) {
      const Vec3& p = mesh.positions[vertex];
      x.take(view.right.dot(p));
      y.take(view.up.dot(p));
      z.take(view.backward.dot(p));
    }
  }
  view.centre = x.middle() * view.right + y.middle() * view.up + z.middle() * view.backward;
  const double across_box = (box.high.x - box.low.x) / std::max(x.span(), std::numeric_limits<double>::min());
  const double up_box = (box.high.y - box.low.y) / std::max(y.span(), std::numeric_limits<double>::min());
  view.pixels_a_metre = std::min(across_box, up_box);
  return view;
}

Vec3 oblique(const Vec3& direction, const Vec3& up, double raise, double aside) {
  const Vec3 d = direction.normalized();
  const Vec3 u = across(up, d);
  const Vec3 beside = u.cross(d);
  const Vec3 turned = std::cos(aside) * d + std::sin(aside) * beside;
  return std::cos(raise) * turned + std::sin(raise) * u;
}

}  // namespace lrcs
