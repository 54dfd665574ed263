#pragma once
#include <BRepAdaptor_Surface.hxx>
#include <array>
#include <vector>

#include "base/vec3.h"

namespace lrcs {

// A place of a face's tessellation: in space, and in the parameters of its surface.
struct FaceNode {
  Vec3 at;
  Eigen::Vector2d uv;
  int pole = -1;  // where the surface is a point: the parameter (0, 1) along which it is; else -1
};

// Twice the area between two steps in the parameters, signed.
[[nodiscard]] inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

using NodeTriples = std::vector<std::array<int, 3>>;

// Makes facets of a face fit for integrals over its surface, and adds the nodes that it needs, which lie within the
// face. Splits edges: where a facet is wide at a pole (its sides there turn by more than a quarter of a radian), and
// where facets cross a line on which the surface's second derivatives jump (knots of B-splines). What cannot be split
// without touching the face's rim stays. Then exchanges the edge between two facets of a face for the other diagonal
// where they bend against the surface: facets of a surface that bulges everywhere make a convex body, decided exactly,
// and do not stand in each other's light. Facets of a saddle, and of surfaces that are straight in one direction, stay.
// What the facets cover together stays as it is in the parameters. facets: nodes by number, from 0, in the order in
// which the parameters turn. cost: some microseconds an edge.
void fit_to_surface(NodeTriples& facets, std::vector<FaceNode>& nodes, const BRepAdaptor_Surface& surface);

}  // namespace lrcs
