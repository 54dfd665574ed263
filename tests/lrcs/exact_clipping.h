#pragma once
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "mesh/facet_mesh.h"

namespace lrcs {

// Seen fraction of a facet by brute force in rational arithmetic: every facet is cut with the facet's plane, projected,
// and taken away from what is left of the facet, piece by piece. Shares nothing with lrcs/. Cost: facets^2 pieces and
// more.
class ExactClipping {
 public:
  explicit ExactClipping(const FacetMesh& mesh) : mesh_(mesh) {}

  // Nothing where a viewer sees the facet exactly edge-on. `viewers`: directions toward them.
  [[nodiscard]] std::optional<double> seen_fraction(std::size_t facet, const std::vector<Vec3>& viewers) const {
    const auto corners = mesh_.corners(facet);
    const Triple origin = triple(corners[0]), e1 = minus(triple(corners[1]), origin),
                 e2 = minus(triple(corners[2]), origin);
    const Triple normal = cross(e1, e2);
    std::vector<int> sides;
    for (const Vec3& d : viewers) {
      sides.push_back(sgn(dot(normal, triple(d))));
      if (sides.back() == 0) return std::nullopt;
    }
    if (sides.front() != sides.back()) return 0.0;
    std::vector<Polygon> left{{{0, 0}, {1, 0}, {0, 1}}};
    for (const Vec3& viewer : viewers) {
      const Triple d = triple(viewer);
      const Rational facing = dot(normal, d);
      const Triple to_u = over(cross(e2, d), facing), to_v = over(cross(d, e1), facing);
      for (std::size_t other = 0; other < mesh_.size(); ++other) {
        if (other == facet) continue;
        std::vector<Vertex> vertices;
        for (const Vec3& p : mesh_.corners(other)) {
          const Triple x = minus(triple(p), origin);
          vertices.push_back({dot(x, to_u), dot(x, to_v), dot(x, normal) * sides.front()});
        }
        if (covers(vertices, other, facet, d, sides.front())) take_away(left, in_front(vertices));
      }
    }
    Rational sum = 0;
    for (const Polygon& p : left) sum += area(p);
    return Rational(2 * sum).get_d();
  }

 private:
  using Rational = mpq_class;
  using Triple = std::array<Rational, 3>;
  struct Point {
    Rational u, v;
  };
  struct Vertex {
    Rational u, v, height;
  };
  using Polygon = std::vector<Point>;

  static Triple triple(const Vec3& p) { return {Rational(p.x()), Rational(p.y()), Rational(p.z())}; }
  static Triple minus(const Triple& a, const Triple& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
  static Triple over(const Triple& a, const Rational& b) { return {a[0] / b, a[1] / b, a[2] / b}; }
  static Rational dot(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static Triple cross(const Triple& a, const Triple& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  // Is the other facet before the facet somewhere, or in its plane and first in rank?
  bool covers(const std::vector<Vertex>& p, std::size_t other, std::size_t facet, const Triple& d, int side) const {
    if (std::any_of(p.begin(), p.end(), [](const Vertex& x) { return x.height > 0; })) return true;
    if (std::any_of(p.begin(), p.end(), [](const Vertex& x) { return x.height < 0; })) return false;
    const auto [a, b, c] = mesh_.corners(other);
    const int other_side = sgn(dot(cross(minus(triple(b), triple(a)), minus(triple(c), triple(a))), d));
    return other_side != side ? other_side > 0 : other < facet;
  }

  static Polygon in_front(const std::vector<Vertex>& p) {
    Polygon kept;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vertex &a = p[k], &b = p[(k + 1) % 3];
      if (a.height >= 0) kept.push_back({a.u, a.v});
      if (sgn(a.height) * sgn(b.height) < 0) {
        const Rational t = a.height / (a.height - b.height);
        kept.push_back({a.u + t * (b.u - a.u), a.v + t * (b.v - a.v)});
      }
    }
    return kept;
  }

  static Rational area(const Polygon& p) {
    Rational twice = 0;
    for (std::size_t k = 0; k < p.size(); ++k) {
      const Point &a = p[k], &b = p[(k + 1) % p.size()];
      twice += a.u * b.v - b.u * a.v;
    }
    return twice / 2;
  }

  // The part of a convex polygon on the left (side 1) or right (side -1) of the line from a to b.
  static Polygon half(const Polygon& p, const Point& a, const Point& b, int side) {
    const auto height = [&](const Point& x) {
      return Rational(side * ((b.u - a.u) * (x.v - a.v) - (b.v - a.v) * (x.u - a.u)));
    };
    Polygon kept;
    for (std::size_t k = 0; k < p.size(); ++k) {
      const Point &from = p[k], &to = p[(k + 1) % p.size()];
      const Rational at_from = height(from), at_to = height(to);
      if (at_from >= 0) kept.push_back(from);
      if (sgn(at_from) * sgn(at_to) < 0) {
        const Rational t = at_from / (at_from - at_to);
        kept.push_back({from.u + t * (to.u - from.u), from.v + t * (to.v - from.v)});
      }
    }
    return kept;
  }

  static void take_away(std::vector<Polygon>& left, Polygon layer) {
    if (layer.size() < 3 || area(layer) == 0) return;
    if (area(layer) < 0) std::reverse(layer.begin(), layer.end());
    std::vector<Polygon> remaining;
    for (Polygon rest : left) {
      for (std::size_t k = 0; k < layer.size() && rest.size() > 2; ++k) {
        const Point &a = layer[k], &b = layer[(k + 1) % layer.size()];
        Polygon outside = half(rest, a, b, -1);
        if (outside.size() > 2 && area(outside) != 0) remaining.push_back(std::move(outside));
        rest = half(rest, a, b, 1);
      }
    }
    left = std::move(remaining);
  }

  const FacetMesh& mesh_;
};

}  // namespace lrcs
