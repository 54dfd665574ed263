#include "cad/fitted_facets.h"

#include <TColStd_Array1OfReal.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "mesh/exact_height.h"

namespace lrcs {
namespace {

using Uv = Eigen::Vector2d;
using Edge = std::pair<int, int>;

// Whether a surface curves the same way in all directions, of like size: k1 k2 (k1 + k2)^2 / 4 are the determinant and
// half the trace of its curvature, squared. l, m, n: second derivatives along the normal, of any length.
bool bulges(const gp_Vec& by_u, const gp_Vec& by_v, double l, double m, double n) {
  constexpr double like = 0.01;
  const double e = by_u.SquareMagnitude(), f = by_u.Dot(by_v), g = by_v.SquareMagnitude();
  const double area = e * g - f * f, mean = 0.5 * (e * n - 2.0 * f * m + g * l) / area;
  return (l * n - m * m) / area > like * mean * mean;
}

class Fitting {
 public:
  Fitting(NodeTriples& facets, std::vector<FaceNode>& nodes, const BRepAdaptor_Surface& surface)
      : facets_(facets), nodes_(nodes), surface_(surface) {
    for (std::size_t f = 0; f < facets.size(); ++f) enter(f);
    find_breaks();
  }

  void run() {
    split_at_breaks();
    split_at_poles();
    waiting_ = edges();
    exchange_edges();
    // An exchange may widen a facet at a pole.
    constexpr int most_rounds = 4;
    for (int round = 0; round < most_rounds && split_at_poles(); ++round) exchange_edges();
  }

 private:
  struct Quad {
    int a, b, c, d;  // facets (a, b, c) and (b, a, d)
    std::size_t left, right;
  };

  void find_breaks() {
    const auto inner = [](int count, auto&& fill, std::vector<double>& breaks) {
      TColStd_Array1OfReal at(1, count + 1);
      fill(at);
      for (int k = 2; k <= count; ++k) breaks.push_back(at(k));
    };
    inner(
        surface_.NbUIntervals(GeomAbs_C2), [&](auto& at) { surface_.UIntervals(at, GeomAbs_C2); }, breaks_[0]);
    inner(
        surface_.NbVIntervals(GeomAbs_C2), [&](auto& at) { surface_.VIntervals(at, GeomAbs_C2); }, breaks_[1]);
  }

  // Each once.
  [[nodiscard]] std::vector<Edge> edges() const {
    std::vector<Edge> all;
    for (const auto& [edge, facet] : across_)
      if (edge.first < edge.second) all.push_back(edge);
    return all;
  }

  // Where an edge crosses a break of the parameter `axis`, as a share of it; none: nowhere between its ends.
  [[nodiscard]] std::optional<double> crossing(int a, int b, int axis, double at) const {
    if (node(a).pole >= 0 || node(b).pole >= 0) return std::nullopt;
    const double from = node(a).uv[axis], to = node(b).uv[axis], share = (at - from) / (to - from);
    constexpr double end = 1e-6;  // what ends so near to the line ends on it
    if (!(share > end && share < 1.0 - end)) return std::nullopt;
    return share;
  }

  // Where there are more breaks than facets to a side, facets do not get smaller by them alone.
  void split_at_breaks() {
    const auto breaks = static_cast<double>(breaks_[0].size() + breaks_[1].size());
    if (breaks * breaks > static_cast<double>(facets_.size())) return breaks_[0].clear(), breaks_[1].clear();
    for (const int axis : {0, 1})
      for (const double at : breaks_[static_cast<std::size_t>(axis)])
        for (const auto& [a, b] : edges())
          if (const auto share = crossing(a, b, axis, at)) split(a, b, *share);
  }

  // Whether there was anything to split.
  bool split_at_poles() {
    constexpr double widest = 0.25;  // [rad]
    constexpr int most_rounds = 6;   // each halves the angle
    bool has_split = false;
    for (int round = 0; round < most_rounds; ++round) {
      std::vector<Edge> wide;
      for (const auto& facet : facets_)
        for (std::size_t k = 0; k < 3; ++k) {
          const FaceNode &pole = node(facet[k]), &a = node(facet[(k + 1) % 3]), &b = node(facet[(k + 2) % 3]);
          if (pole.pole < 0 || a.pole >= 0 || b.pole >= 0) continue;
          const Vec3 p = a.at - pole.at, q = b.at - pole.at;
          if (std::atan2(p.cross(q).norm(), p.dot(q)) > widest)
            wide.emplace_back(facet[(k + 1) % 3], facet[(k + 2) % 3]);
        }
      for (const auto& [a, b] : wide) has_split = split(a, b, 0.5) || has_split;
    }
    return has_split;
  }

  // Not at the face's rim: then false.
  bool split(int a, int b, double share) {
    const auto one = across_.find({a, b}), other = across_.find({b, a});
    if (one == across_.end() || other == across_.end()) return false;
    const std::size_t left = one->second, right = other->second;
    const int c = opposite(left, a, b), d = opposite(right, a, b), m = static_cast<int>(nodes_.size());
    const Uv uv = node(a).uv + share * (node(b).uv - node(a).uv);
    const gp_Pnt p = surface_.Value(uv.x(), uv.y());
    nodes_.push_back({{p.X(), p.Y(), p.Z()}, uv, -1});
    across_.erase({a, b});
    across_.erase({b, a});
    facets_[left] = {a, m, c};
    facets_[right] = {b, m, d};
    facets_.push_back({m, b, c});
    facets_.push_back({m, a, d});
    for (const std::size_t f : {left, right, facets_.size() - 2, facets_.size() - 1}) enter(f);
    for (const Edge& edge :
         {Edge{a, m}, Edge{m, b}, Edge{m, c}, Edge{m, d}, Edge{a, c}, Edge{c, b}, Edge{b, d}, Edge{d, a}})
      waiting_.push_back(edge);
    return true;
  }

  [[nodiscard]] bool crosses_break(int a, int b) const {
    for (const int axis : {0, 1})
      for (const double at : breaks_[static_cast<std::size_t>(axis)])
        if (crossing(a, b, axis, at)) return true;
    return false;
  }

  void enter(std::size_t facet) {
    const auto& [a, b, c] = facets_[facet];
    across_[{a, b}] = across_[{b, c}] = across_[{c, a}] = facet;
  }

  [[nodiscard]] const FaceNode& node(int k) const { return nodes_[static_cast<std::size_t>(k)]; }

  [[nodiscard]] int opposite(std::size_t facet, int a, int b) const {
    for (const int k : facets_[facet])
      if (k != a && k != b) return k;
    return a;
  }

  // Each exchange on a bulging surface adds volume, so there is an end; rounding must not be what decides that.
  void exchange_edges() {
    for (std::size_t left = 50 * facets_.size(); left > 0 && !waiting_.empty(); --left) {
      const Edge edge = waiting_.back();
      waiting_.pop_back();
      look_at(edge);
    }
  }

  void look_at(const Edge& edge) {
    const auto left = across_.find(edge), right = across_.find({edge.second, edge.first});
    if (left == across_.end() || right == across_.end()) return;
    const auto [a, b] = edge;
    const Quad quad{a, b, opposite(left->second, a, b), opposite(right->second, a, b), left->second, right->second};
    if (across_.contains({quad.c, quad.d}) || across_.contains({quad.d, quad.c})) return;
    if (!crosses_break(quad.c, quad.d) && bends_against(quad)) exchange(quad);
  }

  // Parameters of the four corners: at a pole one of them may be anything.
  [[nodiscard]] std::array<Uv, 4> parameters(const Quad& q) const {
    std::array<Uv, 4> uv{node(q.a).uv, node(q.b).uv, node(q.c).uv, node(q.d).uv};
    const auto settle = [&](std::size_t k, int number, const Uv& like) {
      if (const int along = node(number).pole; along >= 0) uv[k][along] = like[along];
    };
    settle(0, q.a, uv[1]);
    settle(1, q.b, uv[0]);
    const Uv middle = 0.5 * (uv[0] + uv[1]);
    settle(2, q.c, middle);
    settle(3, q.d, middle);
    return uv;
  }

  [[nodiscard]] bool bends_against(const Quad& q) const {
    const auto [a, b, c, d] = parameters(q);
    // The new facets (a, d, c) and (d, b, c) must have a part each of what is there.
    constexpr double least = 1e-3;
    const double one = cross(d - a, c - a), other = cross(b - d, c - d), all = one + other;
    if (!(std::min(one, other) > least * all)) return false;
    const double from_a = one / all, from_c = cross(b - a, c - a) / all;  // shares of the diagonals, where they cross
    const Uv at = a + from_a * (b - a);
    gp_Pnt point;
    gp_Vec by_u, by_v, by_uu, by_vv, by_uv;
    surface_.D2(at.x(), at.y(), point, by_u, by_v, by_uu, by_vv, by_uv);
    const gp_Vec across = by_u.Crossed(by_v);
    const Vec3 here(point.X(), point.Y(), point.Z()), normal(across.X(), across.Y(), across.Z());
    if (!bulges(by_u, by_v, across.Dot(by_uu), across.Dot(by_uv), across.Dot(by_vv))) return false;
    const Vec3 &pa = node(q.a).at, &pb = node(q.b).at, &pc = node(q.c).at, &pd = node(q.d).at;
    const double over_ab = normal.dot(here - (pa + from_a * (pb - pa)));
    const double over_cd = normal.dot(here - (pc + from_c * (pd - pc)));
    if ((over_ab > 0.0) != (over_cd > 0.0)) return false;
    const double front = exact_height(pa, pb, pc, pd);
    return over_ab > 0.0 ? front > 0.0 : front < 0.0;
  }

  void exchange(const Quad& q) {
    across_.erase({q.a, q.b});
    across_.erase({q.b, q.a});
    facets_[q.left] = {q.a, q.d, q.c};
    facets_[q.right] = {q.d, q.b, q.c};
    enter(q.left);
    enter(q.right);
    for (const Edge& edge : {Edge{q.a, q.d}, Edge{q.d, q.b}, Edge{q.b, q.c}, Edge{q.c, q.a}}) waiting_.push_back(edge);
  }

  NodeTriples& facets_;
  std::vector<FaceNode>& nodes_;
  const BRepAdaptor_Surface& surface_;
  std::map<Edge, std::size_t> across_;  // the facet that an edge runs along, in its winding
  std::vector<Edge> waiting_;
  std::array<std::vector<double>, 2> breaks_;  // of u and v
};

}  // namespace

void fit_to_surface(NodeTriples& facets, std::vector<FaceNode>& nodes, const BRepAdaptor_Surface& surface) {
  if (surface.GetType() != GeomAbs_Plane) Fitting(facets, nodes, surface).run();
}

}  // namespace lrcs
