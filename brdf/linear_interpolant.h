#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "base/vec3.h"

namespace lrcs {

// Values at places, and between them: linear in each simplex of a Delaunay triangulation of the places, in as many
// dimensions as they fill (a point, a line, a plane, or space).
// domain: one value a place, at least one; places more than the tolerance apart.
// laws: continuous over the hull of the places; within the least and the largest value; constant where the values are,
// to the
//   last bit; the answer depends on nothing but the place asked for. Safe from many threads at once.
// check: tests/brdf/linear_interpolant_test.cpp.
class LinearInterpolant {
 public:
  // tolerance: places this close to the hull count as in it.
  LinearInterpolant(const std::vector<Vec3>& places, const std::vector<double>& values, double tolerance);

  // None outside the hull.
  [[nodiscard]] std::optional<double> at(const Vec3& place) const;
  // Outside the hull: at the place of the hull nearest to it.
  [[nodiscard]] double nearest(const Vec3& place) const;
  // At least the size of the gradient there; outside, that at the nearest place.
  [[nodiscard]] double steepness(const Vec3& place) const;

  // The least and the largest of the values between which that at a place is drawn. None outside the hull.
  struct Span {
    double least = 0.0, largest = 0.0;
  };
  [[nodiscard]] std::optional<Span> span(const Vec3& place) const;

  // The corners of those faces of the hull that look toward y < 0 or z < 0.
  struct Corner {
    Vec3 place;
    double value = 0.0;
  };
  [[nodiscard]] std::vector<Corner> corners_toward_folds() const;
  // Is the place, to within the tolerance, in the line, the plane or the space that the places fill?
  [[nodiscard]] bool is_level(const Vec3& place) const;

  [[nodiscard]] int dimension() const;
  [[nodiscard]] std::size_t simplices() const;

 private:
  struct Parts;
  std::shared_ptr<const Parts> parts_;
};

}  // namespace lrcs
