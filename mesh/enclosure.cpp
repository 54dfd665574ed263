#include "mesh/enclosure.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <Eigen/Geometry>
#include <map>

namespace lrcs {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using TreeTraits = CGAL::AABB_traits<Kernel, Primitive>;
using Box = Eigen::AlignedBox3d;
using IndexedBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;

Kernel::Point_3 point_of(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

Box box_of(const FacetMesh& mesh, const ClosedShell& shell) {
  Box box;
  for (const std::uint32_t facet : shell.facets) {
    for (const Vec3& corner : mesh.corners(facet)) box.extend(corner);
  }
  return box;
}

// Which boxes lie in others: true. Where too many overlap to look at all of them: all true.
std::vector<bool> boxes_inside(const std::vector<Box>& boxes, std::size_t most_pairs) {
  struct Enough {};  // the only way to stop CGAL early
  std::vector<IndexedBox> indexed;
  indexed.reserve(boxes.size());
  for (const Box& b : boxes)
    indexed.emplace_back(CGAL::Bbox_3(b.min().x(), b.min().y(), b.min().z(), b.max().x(), b.max().y(), b.max().z()),
                         indexed.size());
  std::vector<bool> inside(boxes.size(), false);
  std::size_t pairs = 0;
  try {
    CGAL::box_self_intersection_d(indexed.begin(), indexed.end(), [&](const IndexedBox& a, const IndexedBox& b) {
      if (pairs++ == most_pairs) throw Enough();
      if (boxes[b.info()].contains(boxes[a.info()])) inside[a.info()] = true;
      if (boxes[a.info()].contains(boxes[b.info()])) inside[b.info()] = true;
    });
  } catch (const Enough&) {
    inside.assign(boxes.size(), true);
  }
  return inside;
}

// Calls a function with the number of every triangle that a ray crosses, and counts its work; stops where it is enough.
template <class Visit>
class Traversal {
 public:
  Traversal(const Triangles& triangles, std::size_t& work, std::size_t most_work, Visit visit)
      : triangles_(triangles), work_(work), most_work_(most_work), visit_(visit) {}

  [[nodiscard]] bool go_further() const { return work_ < most_work_; }
  template <class Node>
  bool do_intersect(const Kernel::Ray_3& ray, const Node& node) {
    ++work_;
    return CGAL::do_intersect(ray, node.bbox());
  }
  void intersection(const Kernel::Ray_3& ray, const Primitive& primitive) {
    ++work_;
    if (CGAL::do_intersect(ray, *primitive.id()))
      visit_(static_cast<std::size_t>(primitive.id() - triangles_.cbegin()));
  }

 private:
  const Triangles& triangles_;
  std::size_t& work_;
  std::size_t most_work_;
  Visit visit_;
};

}  // namespace

class Enclosure::Tree {
 public:
  Tree(const FacetMesh& mesh, const std::vector<ClosedShell>& shells) : mesh_(mesh), shells_(shells) {
    for (std::size_t k = 0; k < shells.size(); ++k) add(k);
    box_inside_ = boxes_inside(boxes_, most_work);
    tree_.rebuild(triangles_.begin(), triangles_.end());
    tree_.build();
  }

  bool is_inside_another(std::size_t shell) {
    constexpr std::size_t points = 5;
    const std::vector<std::uint32_t>& facets = shells_[shell].facets;
    if (!box_inside_[shell]) return false;
    int inside = 0;
    for (std::size_t k = 0; k < points && work_ < most_work; ++k) {
      const auto [a, b, c] = mesh_.corners(facets[k * facets.size() / points]);
      inside += is_inside_another(point_of((a + b + c) / 3.0), shell) ? 1 : -1;
    }
    return inside > 0 || work_ >= most_work;
  }

 private:
  void add(std::size_t shell) {
    boxes_.push_back(box_of(mesh_, shells_[shell]));
    auto reversed = shells_[shell].reversed.begin();
    for (const std::uint32_t facet : shells_[shell].facets) {
      const bool is_reversed = reversed != shells_[shell].reversed.end() && *reversed == facet;
      if (is_reversed) ++reversed;
      const auto [a, b, c] = mesh_.corners(facet);
      const Kernel::Triangle_3 triangle(point_of(a), point_of(is_reversed ? c : b), point_of(is_reversed ? b : c));
      if (triangle.is_degenerate()) continue;
      triangles_.push_back(triangle);
      shell_.push_back(shell);
    }
  }

  bool is_inside_another(const Kernel::Point_3& point, std::size_t own) {
    // No direction of a drawing: a ray that ran along an edge would cross two facets there.
    const Kernel::Vector_3 direction(0.3571428, 0.5234567, 0.7731913);
    std::map<std::size_t, int> turns;  // how often each shell goes round the point
    Traversal traversal(triangles_, work_, most_work, [&](std::size_t crossed) {
      const Kernel::Triangle_3& t = triangles_[crossed];
      turns[shell_[crossed]] += CGAL::orientation(t[0], t[1], t[2], point);
    });
    tree_.traversal(Kernel::Ray_3(point, direction), traversal);
    for (const auto& [shell, count] : turns) {
      if (shell != own && count != 0 && boxes_[shell].contains(boxes_[own])) return true;
    }
    return false;
  }

  const FacetMesh& mesh_;
  const std::vector<ClosedShell>& shells_;
  std::vector<Box> boxes_;
  Triangles triangles_;
  std::vector<std::size_t> shell_;  // of each triangle
  CGAL::AABB_tree<TreeTraits> tree_;
  std::vector<bool> box_inside_;  // of each shell: its box lies in another's
  std::size_t work_ = 0;
};

Enclosure::Enclosure(const FacetMesh& welded, const std::vector<ClosedShell>& shells)
    : tree_(std::make_unique<Tree>(welded, shells)) {}
Enclosure::~Enclosure() = default;

bool Enclosure::is_inside_another(std::size_t shell) {
  return tree_->is_inside_another(shell);
}

}  // namespace lrcs
