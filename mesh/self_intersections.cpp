#include "mesh/self_intersections.h"

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <utility>

namespace lrcs {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point3 = Kernel::Point_3;
using NumberedBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;
using Corners = std::array<std::uint32_t, 3>;

class PairTest {
 public:
  explicit PairTest(const FacetMesh& mesh) : mesh_(mesh) {}

  [[nodiscard]] bool intersect(std::uint32_t first, std::uint32_t second) const {
    Corners a = mesh_.facets[first];
    Corners b = mesh_.facets[second];
    switch (shared_to_front(a, b)) {
      case 0:
        return CGAL::do_intersect(triangle(a), triangle(b));
      case 1:
        // What two facets with one common vertex have in common beyond it reaches the opposite edge of one of them.
        return CGAL::do_intersect(triangle(a), opposite_edge(b)) || CGAL::do_intersect(triangle(b), opposite_edge(a));
      case 2:
        return fold_onto_each_other(a, b);
      default:
        return false;
    }
  }

 private:
  // Brings the common vertices to the front of both, in the same order, and counts them.
  static std::size_t shared_to_front(Corners& a, Corners& b) {
    std::size_t shared = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto* const found = std::find(b.begin() + shared, b.end(), a[k]);
      if (found == b.end()) continue;
      std::swap(b[static_cast<std::size_t>(found - b.begin())], b[shared]);
      std::swap(a[k], a[shared++]);
    }
    return shared;
  }

  // Their third vertices lie on the same side of the edge, in one plane: in a coordinate plane that does not flatten
  // them.
  [[nodiscard]] bool fold_onto_each_other(const Corners& a, const Corners& b) const {
    if (!CGAL::coplanar(point(a[0]), point(a[1]), point(a[2]), point(b[2]))) return false;
    for (int axis = 0; axis < 3; ++axis) {
      const auto side = side_of_edge(a, axis);
      if (side != CGAL::COLLINEAR) return side == side_of_edge(b, axis);
    }
    return false;
  }

  // On which side of the edge from corner 0 to corner 1 corner 2 lies, seen along a coordinate axis.
  [[nodiscard]] CGAL::Orientation side_of_edge(const Corners& c, int axis) const {
    const auto seen = [&](std::uint32_t vertex) {
      const Vec3& p = mesh_.positions[vertex];
      return Kernel::Point_2(p[(axis + 1) % 3], p[(axis + 2) % 3]);
    };
    return CGAL::orientation(seen(c[0]), seen(c[1]), seen(c[2]));
  }

  [[nodiscard]] Point3 point(std::uint32_t vertex) const {
    const Vec3& p = mesh_.positions[vertex];
    return {p.x(), p.y(), p.z()};
  }
  [[nodiscard]] Kernel::Triangle_3 triangle(const Corners& c) const { return {point(c[0]), point(c[1]), point(c[2])}; }
  [[nodiscard]] Kernel::Segment_3 opposite_edge(const Corners& c) const { return {point(c[1]), point(c[2])}; }

  const FacetMesh& mesh_;
};

std::vector<NumberedBox> boxes_of(const FacetMesh& mesh) {
  std::vector<NumberedBox> boxes;
  boxes.reserve(mesh.size());
  for (std::uint32_t k = 0; k < mesh.size(); ++k) {
    CGAL::Bbox_3 box;
    for (const Vec3& p : mesh.corners(k)) box += CGAL::Bbox_3(p.x(), p.y(), p.z(), p.x(), p.y(), p.z());
    boxes.emplace_back(box, k);
  }
  return boxes;
}

}  // namespace

SelfIntersections self_intersections(const FacetMesh& welded, std::size_t most_tests) {
  struct Enough {};  // the only way to stop CGAL early
  const PairTest test(welded);
  std::vector<NumberedBox> boxes = boxes_of(welded);
  SelfIntersections result;
  std::size_t left = most_tests + 20 * welded.size();
  try {
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const NumberedBox& a, const NumberedBox& b) {
      if (left-- == 0) throw Enough();
      if (!test.intersect(a.info(), b.info())) return;
      ++result.pairs;
      const auto [low, high] = std::minmax(welded.part.of[a.info()], welded.part.of[b.info()]);
      if (low != high) ++result.between_parts[{low, high}];
    });
  } catch (const Enough&) {
    result.complete = false;
  }
  return result;
}

}  // namespace lrcs
