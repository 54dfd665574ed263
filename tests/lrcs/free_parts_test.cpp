#include "lrcs/free_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <span>

#include "lrcs/never_faced.h"
#include "lrcs/visibility.h"
#include "tests/lrcs/test_targets.h"

namespace lrcs {
namespace {

struct Free {
  std::size_t convex, other;
};

// Parts that nothing stands before; seen fractions are those of the oracle.
Free free_parts(FacetMesh mesh, const Vec3& toward) {
  measure_facets(mesh);
  const Vec3 d = toward.normalized();
  const Visibility visibility(mesh);
  VisibilityCost cost;
  const auto seen = visibility.seen_fraction(d, d, &cost);
  const auto clipped = visibility.seen_fraction_by_clipping(d, d);
  for (std::size_t f = 0; f < mesh.size(); ++f)
    EXPECT_LE(std::abs(seen[f].value - clipped[f].value), seen[f].bound + clipped[f].bound) << f;
  return {cost.free_convex_parts, cost.other_free_parts};
}

std::size_t free_convex(const FacetMesh& mesh, const Vec3& toward) {
  const Free free = free_parts(mesh, toward);
  EXPECT_EQ(free.other, 0U);
  return free.convex;
}

TEST(FreeParts, TwoBoxesSideBySideAreFreeUntilOneStandsBeforeTheOther) {
  FacetMesh mesh = box({0, 0, 0}, {1, 1, 1});
  append(mesh, box({2, 0, 0}, {3, 1, 1}));
  EXPECT_EQ(free_convex(mesh, {0, 0, 1}), 2U);
  EXPECT_EQ(free_convex(mesh, {0, -1, 0}), 2U);
  EXPECT_EQ(free_convex(mesh, {1, 0, 0}), 1U);
  EXPECT_EQ(free_convex(mesh, {-1, 0, 0}), 1U);
  EXPECT_EQ(free_convex(mesh, {0.3, 0, 1}), 2U);
  EXPECT_EQ(free_convex(mesh, {4, 0, 1}), 1U);
}

TEST(FreeParts, ASphereBeforeAPlateIsFreeAndThePlateIsNot) {
  FacetMesh mesh;
  add_tiled_plate(mesh, {-5, -5, 0}, {10, 0, 0}, {0, 10, 0}, 4);
  append(mesh, icosphere(2), {0, 0, 3});
  EXPECT_EQ(free_convex(mesh, {0, 0, 1}), 1U);
  EXPECT_EQ(free_convex(mesh, {0.2, 0.1, 1}), 1U);
  const Free from_behind = free_parts(mesh, {0, 0, -1});
  EXPECT_EQ(from_behind.convex, 0U);
  EXPECT_EQ(from_behind.other, 1U);
}

TEST(FreeParts, ABoxInABoxIsNeverFree) {
  FacetMesh mesh = box({0, 0, 0}, {4, 4, 4});
  append(mesh, box({1, 1, 1}, {2, 2, 2}));
  for (const Vec3& d : {Vec3(1, 0, 0), Vec3(0, 0, -1), Vec3(1, 2, 3)}) EXPECT_EQ(free_convex(mesh, d), 0U);
}

TEST(FreeParts, BoxesThatTouchOrLieOnEachOtherAreNot) {
  FacetMesh touching = box({0, 0, 0}, {1, 1, 1});
  append(touching, box({1, 0, 0}, {2, 1, 1}));
  EXPECT_EQ(free_convex(touching, {0, 0, 1}), 0U);
  FacetMesh twice = box({0, 0, 0}, {1, 1, 1});
  append(twice, box({0, 0, 0}, {1, 1, 2}));
  EXPECT_EQ(free_convex(twice, {0, 1, 1}), 0U);
}

// An L of two boxes' worth: its inner corner is not on its hull.
FacetMesh angle_iron() {
  FacetMesh mesh;
  const std::vector<Vec3> outline{{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
  const Vec3 up(0, 0, 1);
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vec3& from = outline[k];
    add_plate(mesh, from, outline[(k + 1) % outline.size()] - from, up);
  }
  for (const auto& [a, b, c] : {std::array{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}) {
    const auto at = [&](int k) { return outline[static_cast<std::size_t>(k)]; };
    add_triangle(mesh, at(a), at(c), at(b));
    add_triangle(mesh, at(a) + up, at(b) + up, at(c) + up);
  }
  return mesh;
}

TEST(FreeParts, OnesThatAreNotConvexCountApart) {
  FacetMesh mesh = angle_iron();
  append(mesh, angle_iron(), {10, 0, 0});
  const Free beside = free_parts(mesh, {0.1, 0.4, 1});
  EXPECT_EQ(beside.convex, 0U);
  EXPECT_EQ(beside.other, 2U);
  const Free behind = free_parts(mesh, {1, 0.05, 0.05});
  EXPECT_EQ(behind.other, 1U);
}

TEST(FreeParts, OfManySpheresGiveWhatTheOracleGives) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> at(0.0, 20.0);
  FacetMesh mesh;
  for (int k = 0; k < 40; ++k)
    append(mesh, k % 4 == 0 ? angle_iron() : icosphere(1), {at(random), at(random), at(random)});
  std::size_t free = 0;
  for (int k = 0; k < 6; ++k) {
    const Free found = free_parts(mesh, random_direction(random));
    free += found.convex + found.other;
  }
  EXPECT_GT(free, 20U);
}

TEST(FreeParts, AskedOfOnePartAreNone) {
  const Free free = free_parts(icosphere(2), {1, 2, 3});
  EXPECT_EQ(free.convex + free.other, 0U);
}

std::size_t never_faced(const FacetMesh& mesh, const std::vector<Vec3>& viewers) {
  const auto faced = facets_ever_faced(Surface(mesh), viewers);
  return static_cast<std::size_t>(std::ranges::count(faced, 0));
}

TEST(NeverFaced, AreTheBacksOfSolidsAlone) {
  const FacetMesh mesh = angle_iron();
  const Vec3 up(0, 0, 1), x(1, 0, 0);
  // Edge-on is not turned away, as rounding might have it otherwise.
  EXPECT_EQ(never_faced(mesh, {up}), 4U);
  EXPECT_EQ(never_faced(mesh, {Vec3(0.1, 0.1, 1).normalized()}), 4U + 4U);
  EXPECT_EQ(never_faced(mesh, {up, -up}), 0U);
  FacetMesh open = mesh;
  open.facets.pop_back();
  EXPECT_EQ(never_faced(open, {up}), 0U);
  EXPECT_EQ(never_faced(mesh, {up, x}), 0U);
}

TEST(NeverFaced, LeftOutChangeNothing) {
  std::mt19937_64 random(5);
  FacetMesh mesh = sphere(1.0, 20);
  for (Vec3& p : mesh.positions) p *= 1.0 + 0.2 * std::sin(7 * p.x()) * std::sin(9 * p.y() + 1);
  append(mesh, angle_iron(), {1.5, -1, 0});
  append(mesh, icosphere(2), {0, 3, 0});
  add_plate(mesh, {-2, -2, -1.5}, {4, 0, 0}, {0, 4, 0});
  measure_facets(mesh);
  std::vector<Vec3> viewers;
  for (int k = 0; k < 600; ++k) viewers.push_back((Vec3(3, 0, 0.5) + random_direction(random)).normalized());
  const Visibility whole(mesh);
  Visibility less(mesh);
  // Two viewers would not make up for it.
  EXPECT_EQ(less.look_only_from(std::span(viewers).first(2)), 0U);
  EXPECT_GT(less.look_only_from(viewers), mesh.size() / 4);
  for (std::size_t k = 0; k + 1 < viewers.size(); k += 75)
    for (const Vec3& di : {viewers[k], viewers[k + 1]}) {
      const auto all = whole.seen_fraction(di, viewers[k]), some = less.seen_fraction(di, viewers[k]);
      for (std::size_t f = 0; f < mesh.size(); ++f)
        EXPECT_LE(std::abs(all[f].value - some[f].value), all[f].bound + some[f].bound) << f;
    }
}

}  // namespace
}  // namespace lrcs
