#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "base/vec3.h"
#include "mesh/curved_patch.h"

namespace lrcs {

// A place on a facet, and how its surface faces the two directions there.
struct RimCorner {
  std::array<double, 3> at;
  double facing_i, facing_r;  // cosines times area, of the side looked at
};

// At most a triangle cut by two lines, each bent once.
struct RimPolygon {
  std::array<RimCorner, 9> corners;
  std::size_t size = 0;

  void add(const RimCorner& corner) { corners[size++] = corner; }

  [[nodiscard]] const RimCorner& after(std::size_t corner, std::size_t steps) const {
    return corners[(corner + steps) % size];
  }

  // The corner to draw a fan of triangles from: the most reflex one, a bend, if there is one. (Of two bends, triangles
  // that lie outside have areas below zero.)
  [[nodiscard]] std::size_t most_reflex() const {
    std::size_t most = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < size; ++k) {
      const auto &a = after(k, size - 1).at, &b = corners[k].at, &c = after(k, 1).at;
      const double turn = (b[1] - a[1]) * (c[2] - b[2]) - (b[2] - a[2]) * (c[1] - b[1]);
      if (turn < least) least = turn, most = k;
    }
    return most;
  }
};

inline RimCorner between(const RimCorner& a, const RimCorner& b, double share) {
  RimCorner c{};
  for (std::size_t k = 0; k < 3; ++k) c.at[k] = a.at[k] + share * (b.at[k] - a.at[k]);
  c.facing_i = a.facing_i + share * (b.facing_i - a.facing_i);
  c.facing_r = a.facing_r + share * (b.facing_r - a.facing_r);
  return c;
}

// Does one of the directions see some of the corners turned away, and others not?
inline bool is_turned_in_part(const std::array<RimCorner, 3>& corners) {
  const auto differ = [&](double RimCorner::*facing) {
    const bool first = corners[0].*facing > 0.0;
    return (corners[1].*facing > 0.0) != first || (corners[2].*facing > 0.0) != first;
  };
  return differ(&RimCorner::facing_i) || differ(&RimCorner::facing_r);
}

// The surface of one facet, how it faces the directions at any place, and what of a part of it does.
struct RimCut {
  const PatchPolynomial& surface;
  Vec3 wi, wr;  // of the side looked at

  [[nodiscard]] RimCorner at(const std::array<double, 3>& place) const {
    const Vec3 vector = surface.at(place);
    return {place, vector.dot(wi), vector.dot(wr)};
  }

  [[nodiscard]] RimCorner half_way(const RimCorner& a, const RimCorner& b) const { return at(between(a, b, 0.5).at); }

  // Where the surface turns away between two places: a line, and a parabola through three of its places.
  [[nodiscard]] RimCorner turn(const RimCorner& a, const RimCorner& b, double RimCorner::*facing) const {
    const double from = a.*facing, to = b.*facing;
    const RimCorner first = at(between(a, b, from / (from - to)).at);
    const bool is_beyond = (first.*facing > 0.0) == (from > 0.0);
    const double near = first.*facing, other = is_beyond ? to : from;
    if (near == 0.0 || !(near / (near - other) <= 1.0)) return first;
    return at(between(first, is_beyond ? b : a, near / (near - other)).at);
  }

  // Half way along the line from where a polygon's rim leaves what faces the direction to where it comes back, moved
  // so far that the two pieces have the area of the parabola over it.
  [[nodiscard]] RimCorner bend(const RimCorner& leaves, const RimCorner& enters, double RimCorner::*facing) const {
    const RimCorner middle = half_way(leaves, enters);
    // Across the line on the facet; how facing changes there is taken from a step as long as a quarter of it.
    const std::array<double, 3> along{enters.at[0] - leaves.at[0], enters.at[1] - leaves.at[1],
                                      enters.at[2] - leaves.at[2]};
    RimCorner aside = middle;
    for (std::size_t k = 0; k < 3; ++k)
      aside.at[k] += 0.25 / std::sqrt(3.0) * (along[(k + 1) % 3] - along[(k + 2) % 3]);
    aside = at(aside.at);
    const double change = aside.*facing - middle.*facing;
    constexpr double of_area = 4.0 / 3.0;  // two thirds of the parabola's height against half of the triangle's
    const double step = -of_area * middle.*facing / change;
    if (!(std::abs(step) <= 1.0)) return middle;
    return at(between(middle, aside, step).at);
  }

  // What of a polygon faces a direction.
  [[nodiscard]] RimPolygon cut(const RimPolygon& polygon, double RimCorner::*facing) const {
    RimPolygon rest;
    for (std::size_t k = 0; k < polygon.size; ++k) {
      const RimCorner &a = polygon.corners[k], &b = polygon.corners[(k + 1) % polygon.size];
      if (a.*facing > 0.0) {
        rest.add(a);
        if (b.*facing > 0.0) continue;
        const RimCorner leaves = turn(a, b, facing);
        rest.add(leaves);
        if (const auto enters = entry(polygon, k + 1, facing)) rest.add(bend(leaves, *enters, facing));
      } else if (b.*facing > 0.0) {
        rest.add(turn(a, b, facing));
      }
      if (rest.size + 3 > rest.corners.size()) break;
    }
    return rest;
  }

 private:
  // Where the rim comes back, from corner `from` on.
  [[nodiscard]] std::optional<RimCorner> entry(const RimPolygon& polygon, std::size_t from,
                                               double RimCorner::*facing) const {
    for (std::size_t k = 0; k < polygon.size; ++k) {
      const RimCorner& a = polygon.corners[(from + k) % polygon.size];
      const RimCorner& b = polygon.corners[(from + k + 1) % polygon.size];
      if (a.*facing <= 0.0 && b.*facing > 0.0) return turn(a, b, facing);
    }
    return std::nullopt;
  }
};

}  // namespace lrcs
