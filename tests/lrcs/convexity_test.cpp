#include "lrcs/convexity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>

#include "mesh/normal_patches.h"
#include "tests/lrcs/test_targets.h"

namespace lrcs {
namespace {

FacetMesh brick() {
  return box({-1, -2, -3}, {1, 2, 3});
}

// Two fans over a polygon that goes round n corners in steps of `step`: with step > 1 a star, wound more than once.
FacetMesh bipyramid(std::uint32_t n, std::uint32_t step) {
  FacetMesh mesh;
  for (std::uint32_t k = 0; k < n; ++k) {
    const double phi = 2.0 * std::numbers::pi * (k * step % n) / n;
    add_vertex(mesh, {std::cos(phi), std::sin(phi), 0.0});
  }
  const auto top = add_vertex(mesh, {0, 0, 1}), bottom = add_vertex(mesh, {0, 0, -1});
  for (std::uint32_t k = 0; k < n; ++k) {
    add_facet(mesh, k, (k + 1) % n, top);
    add_facet(mesh, (k + 1) % n, k, bottom);
  }
  return mesh;
}

TEST(IsConvexBody, HoldsForConvexBodiesWhateverTheirFacets) {
  EXPECT_TRUE(is_convex_body(brick()));
  EXPECT_TRUE(is_convex_body(icosphere(4)));
  EXPECT_TRUE(is_convex_body(bipyramid(7, 1)));
  FacetMesh corner;  // the middle of its box is outside
  const Vec3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  add_triangle(corner, o, y, x);
  add_triangle(corner, o, z, y);
  add_triangle(corner, o, x, z);
  add_triangle(corner, x, y, z);
  EXPECT_TRUE(is_convex_body(corner));
  for (const double scale : {1e-90, 1e-9, 1e9, 1e90}) {
    FacetMesh scaled = corner;
    for (Vec3& p : scaled.positions) p *= scale;
    EXPECT_TRUE(is_convex_body(scaled)) << scale;
  }
}

TEST(IsConvexBody, HoldsWithManyCoplanarFacets) {
  FacetMesh mesh = brick();
  FacetMesh split;
  for (std::size_t k = 0; k < mesh.size(); ++k) {
    const auto [a, b, c] = mesh.corners(k);
    const Vec3 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
    add_triangle(split, a, ab, ca);
    add_triangle(split, ab, b, bc);
    add_triangle(split, ca, bc, c);
    add_triangle(split, ab, bc, ca);
  }
  EXPECT_TRUE(is_convex_body(split));
}

// A corner moved by one bit out of a face folds it along its diagonal: one way a ridge, the other way a valley.
TEST(IsConvexBody, FailsByTheLastBit) {
  const auto is_convex_with_corner_at = [](double x) {
    FacetMesh mesh = brick();
    for (Vec3& p : mesh.positions)
      if (p == Vec3(1, 2, 3)) p.x() = x;
    return is_convex_body(mesh);
  };
  EXPECT_TRUE(is_convex_with_corner_at(1.0));
  EXPECT_NE(is_convex_with_corner_at(std::nextafter(1.0, 2.0)), is_convex_with_corner_at(std::nextafter(1.0, 0.0)));
}

TEST(IsConvexBody, FailsForWhatIsOpenInwardDentedOrNotOneBody) {
  FacetMesh open = brick();
  open.facets.pop_back();
  EXPECT_FALSE(is_convex_body(open));
  EXPECT_FALSE(is_convex_body(reversed(brick())));
  FacetMesh one_turned = brick();
  std::swap(one_turned.facets[5][1], one_turned.facets[5][2]);
  EXPECT_FALSE(is_convex_body(one_turned));
  FacetMesh two = brick();
  append(two, brick(), {10, 0, 0});
  EXPECT_FALSE(is_convex_body(two));
  FacetMesh within = brick(), small = brick();
  for (Vec3& p : small.positions) p *= 0.5;
  append(within, small);
  EXPECT_FALSE(is_convex_body(within));
  FacetMesh twice = brick();
  append(twice, brick());
  EXPECT_FALSE(is_convex_body(twice));
  FacetMesh dented = bipyramid(12, 1);
  dented.positions[3] *= 0.7;
  EXPECT_FALSE(is_convex_body(dented));
  EXPECT_FALSE(is_convex_body({}));
  FacetMesh plate;
  add_plate(plate, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  append(plate, reversed(plate));
  EXPECT_FALSE(is_convex_body(plate));
}

// A ball whose normals are its own, two facets of which share the wrong diagonal and so bend forward.
FacetMesh ball_with_a_forward_bend(double of_the_radius = 1.0) {
  FacetMesh ball = icosphere(3);
  auto& [a, b, c] = ball.facets[0];
  const auto beside = std::ranges::find_if(ball.facets.begin() + 1, ball.facets.end(), [&](const auto& f) {
    return std::ranges::find(f, a) != f.end() && std::ranges::find(f, b) != f.end();
  });
  const std::uint32_t d = *std::ranges::find_if(*beside, [&](std::uint32_t v) { return v != a && v != b; });
  *beside = {d, b, c};
  b = d;
  CornerNormals normals;
  for (const auto& f : ball.facets)
    normals.push_back(
        {ball.positions[f[0]].normalized(), ball.positions[f[1]].normalized(), ball.positions[f[2]].normalized()});
  ball.positions[d] *= of_the_radius;
  measure_facets(ball);
  curve_by_normals(ball, normals);
  return ball;
}

TEST(IsConvexBody, HoldsForACurvedBodyWhoseFacetsBendForwardWhereItsSurfaceDoesNot) {
  FacetMesh ball = ball_with_a_forward_bend();
  ASSERT_FALSE(ball.curved.patches.empty());
  EXPECT_TRUE(is_convex_body(ball));
  ball.curved = {};
  EXPECT_FALSE(is_convex_body(ball));
  EXPECT_FALSE(is_convex_body(ball_with_a_forward_bend(0.8)));  // whatever its normals say
}

// Every edge bends back and the middle is behind every facet, and yet the surface goes round twice and meets itself.
TEST(IsConvexBody, FailsForAStarWoundTwice) {
  EXPECT_FALSE(is_convex_body(bipyramid(5, 2)));
  EXPECT_FALSE(is_convex_body(bipyramid(7, 3)));
}

// Against the definition: no vertex before any facet's plane.
TEST(IsConvexBody, IsNoVertexBeforeAnyFacet) {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> radius(0.5, 1.0);
  int convex = 0;
  for (int round = 0; round < 200; ++round) {
    FacetMesh mesh = bipyramid(9, 1);
    for (Vec3& p : mesh.positions) p *= radius(random);
    bool none_before = true;
    for (std::size_t k = 0; k < mesh.size(); ++k) {
      const auto [a, b, c] = mesh.corners(k);
      for (const Vec3& p : mesh.positions) none_before = none_before && facet_cross(a, b, c).dot(p - a) < 1e-12;
    }
    EXPECT_EQ(is_convex_body(mesh), none_before);
    convex += none_before ? 1 : 0;
  }
  EXPECT_GT(convex, 20);
  EXPECT_LT(convex, 180);
}

}  // namespace
}  // namespace lrcs
