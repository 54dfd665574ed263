#include "bench/spacecraft.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "mesh/mesh_builder.h"

namespace lrcs {
namespace {

using Ring = std::vector<Vec3>;

// The solid with these rings around it, from the near cap to the far one, counter-clockwise seen from the far end; caps
// are fans, as CAD meshers make them.
void add_solid(MeshBuilder& mesh, const std::vector<Ring>& rings) {
  const auto sides = static_cast<std::uint32_t>(rings.front().size());
  const auto near = static_cast<std::uint32_t>(mesh.position_count());
  for (const Ring& ring : rings)
    for (const Vec3& p : ring) mesh.add_position(p);
  const std::uint32_t far = static_cast<std::uint32_t>(mesh.position_count()) - sides;
  for (std::uint32_t first = near; first < far; first += sides)
    for (std::uint32_t k = 0; k < sides; ++k) {
      const std::uint32_t a = first + k, b = first + (k + 1) % sides;
      mesh.add_polygon(std::array{a, b, b + sides});
      mesh.add_polygon(std::array{a, b + sides, a + sides});
    }
  for (std::uint32_t k = 1; k + 1 < sides; ++k) {
    mesh.add_polygon(std::array{near, near + k + 1, near + k});
    mesh.add_polygon(std::array{far, far + k, far + k + 1});
  }
}

void add_box(MeshBuilder& mesh, const Vec3& low, const Vec3& high) {
  const auto ring = [&](double z) {
    return Ring{{low.x(), low.y(), z}, {high.x(), low.y(), z}, {high.x(), high.y(), z}, {low.x(), high.y(), z}};
  };
  add_solid(mesh, {ring(low.z()), ring(high.z())});
}

Ring circle(const Vec3& centre, const Vec3& axis, double radius, std::uint32_t sides) {
  const Vec3 u = axis.unitOrthogonal();
  const Vec3 v = axis.normalized().cross(u);
  Ring points;
  for (std::uint32_t k = 0; k < sides; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / sides;
    points.emplace_back(centre + radius * (std::cos(angle) * u + std::sin(angle) * v));
  }
  return points;
}

struct Cone {
  Vec3 near, far;                  // ends of the axis
  double near_radius, far_radius;  // [m]
  std::uint32_t sides;
};

void add_cone(MeshBuilder& mesh, const Cone& cone) {
  const Vec3 axis = cone.far - cone.near;
  add_solid(mesh, {circle(cone.near, axis, cone.near_radius, cone.sides),
                   circle(cone.far, axis, cone.far_radius, cone.sides)});
}

void add_bar(MeshBuilder& mesh, const Vec3& from, const Vec3& to, double radius) {
  constexpr std::uint32_t sides = 6;
  add_cone(mesh, {from, to, radius, radius, sides});
}

// Three panels a wing, each with its frame on the cells' side, on a yoke. side: +1 left, -1 right.
void add_wing(MeshBuilder& mesh, double side) {
  const auto box = [&](Vec3 a, Vec3 b) {
    a.y() *= side;
    b.y() *= side;
    add_box(mesh, a.cwiseMin(b), a.cwiseMax(b));
  };
  add_bar(mesh, {-0.5, 0.8 * side, 0.0}, {0.0, 1.6 * side, 0.0}, 0.03);
  add_bar(mesh, {0.5, 0.8 * side, 0.0}, {0.0, 1.6 * side, 0.0}, 0.03);
  for (int panel = 0; panel < 3; ++panel) {
    const double y = 1.6 + 2.05 * panel;
    box({-0.9, y, -0.015}, {0.9, y + 2.0, 0.015});
    for (int strip = 0; strip < 9; ++strip) {
      const double x = -0.86 + 0.195 * strip;
      box({x, y + 0.03, 0.015}, {x + 0.16, y + 1.97, 0.02});
    }
    if (panel > 0) add_bar(mesh, {-0.7, (y - 0.08) * side, 0.0}, {0.7, (y - 0.08) * side, 0.0}, 0.025);
  }
}

// A square boom forward, with diagonals, whose bars pass through each other in the nodes.
void add_truss(MeshBuilder& mesh) {
  constexpr int bays = 12;
  constexpr double bay = 0.3, half = 0.15, foot = 1.0, radius = 0.012;  // [m]
  const auto node = [&](int at, int corner) {
    const double y = corner == 0 || corner == 3 ? -half : half;
    return Vec3(foot + bay * at, y, corner < 2 ? -half : half);
  };
  for (int at = 0; at < bays; ++at)
    for (int corner = 0; corner < 4; ++corner) {
      const int next = (corner + 1) % 4;
      add_bar(mesh, node(at, corner), node(at + 1, corner), radius);
      add_bar(mesh, node(at + 1, corner), node(at + 1, next), radius);
      add_bar(mesh, node(at, at % 2 == 0 ? corner : next), node(at + 1, at % 2 == 0 ? next : corner), 0.7 * radius);
    }
}

// A paraboloid of sheet metal, open to above, on a post, with its feed on three legs.
void add_dish(MeshBuilder& mesh, const Vec3& foot) {
  constexpr std::uint32_t sides = 72;
  constexpr int rings = 8;
  constexpr double radius = 0.75, focal_length = 0.6, thickness = 0.02, post = 0.25;  // [m]
  const Vec3 up = Vec3::UnitZ();
  const auto on_dish = [&](double r) { return Vec3(foot + (post + r * r / (4.0 * focal_length)) * up); };
  std::vector<Ring> wall;
  for (int k = 1; k <= rings; ++k) wall.push_back(circle(on_dish(radius * k / rings), up, radius * k / rings, sides));
  for (int k = rings; k >= 1; --k) {
    const double r = radius * k / rings;
    wall.push_back(circle(on_dish(r) + thickness * up, up, r, sides));
  }
  add_solid(mesh, wall);
  add_cone(mesh, {foot, on_dish(radius / rings), 0.06, 0.06, 24});
  const Vec3 feed = foot + (post + focal_length) * up;
  for (const Vec3& on_rim : circle(on_dish(radius), up, radius, 3)) add_bar(mesh, on_rim, feed, 0.01);
  add_cone(mesh, {feed, feed + 0.1 * up, 0.05, 0.08, 24});
}

void add_body(MeshBuilder& mesh) {
  add_box(mesh, {-1.0, -0.8, -0.9}, {1.0, 0.8, 0.9});
  for (int fin = 0; fin < 14; ++fin) {  // radiator fins that stand on the lower side
    const double x = -0.9 + 0.13 * fin;
    add_box(mesh, {x, -0.7, -1.2}, {x + 0.01, 0.7, -0.9});
  }
  for (const double y : {-0.45, 0.45}) add_cone(mesh, {{-1.8, y, 0.3}, {-1.0, y, 0.3}, 0.3, 0.3, 96});  // tanks
  for (const double y : {-0.3, 0.3})
    for (const double z : {-0.6, -0.2}) add_cone(mesh, {{-1.35, y, z}, {-1.0, y, z}, 0.14, 0.05, 48});  // nozzles
  add_cone(mesh, {{1.0, -0.5, 0.5}, {1.5, -0.5, 0.5}, 0.2, 0.2, 128});                                  // telescope
  for (int box = 0; box < 4; ++box)
    add_box(mesh, {-0.8 + 0.35 * box, 0.2, 0.9}, {-0.55 + 0.35 * box, 0.6, 1.0 + 0.05 * box});
}

}  // namespace

FacetMesh spacecraft() {
  MeshBuilder mesh;
  add_body(mesh);
  add_wing(mesh, 1.0);
  add_wing(mesh, -1.0);
  add_truss(mesh);
  add_dish(mesh, {0.1, -0.2, 0.9});
  return mesh.finish();
}

}  // namespace lrcs
