#include "lrcs/sampled_sections.h"

#include <gtest/gtest.h>

#include <numbers>

#include "lrcs/drawn_sums.h"
#include "lrcs/embree_scene.h"
#include "lrcs/row_spread.h"
#include "lrcs/row_sums.h"
#include "lrcs/sweep.h"
#include "lrcs/touching_facets.h"
#include "tests/lrcs/honest_samples.h"

namespace lrcs {
namespace {

// Two dented bodies, one before the other: many facets, so that sampling pays.
FacetMesh two_spheres(double size = 1.0, const Vec3& at = Vec3::Zero()) {
  FacetMesh mesh = sphere(1.0, 60);
  append(mesh, sphere(0.7, 60), {1.2, 0.3, 0.2});
  for (Vec3& p : mesh.positions) p = size * p + at;
  return mesh;
}

TEST(SampledSections, AreWithinTheirBoundAndTheBoundWithinWhatWasAsked) {
  for (const bool bistatic : {false, true}) {
    expect_honest(target_of(two_spheres(), lambert(0.5)), 2e-2, bistatic, 1);
    expect_honest(target_of(two_spheres(), library("metal-skin-5p")), 1e-2, bistatic, 2);
  }
}

TEST(SampledSections, HoldForTinyTargetsAndThoseFarFromTheOrigin) {
  expect_honest(target_of(two_spheres(1e-9), lambert(0.5)), 2e-2, false, 3);
  expect_honest(target_of(two_spheres(1.0, {1e6, -2e6, 1e6}), lambert(0.5)), 2e-2, false, 4);
}

TEST(SampledSections, DoNotChangeForVerticesOfNoFacet) {
  const Target target = target_of(two_spheres(), library("metal-skin-5p"));
  Target strayed = target;
  strayed.mesh.positions.push_back({1e5, 0, 0});
  strayed.mesh.positions.push_back({0, 1e12, -1e12});
  const Vec3 d = Vec3(1, 2, 3).normalized(), other = Vec3(1, 2, 2).normalized();
  for (const Vec3& di : {d, other}) {
    const auto one = SampledSections(target, 1e-2, true).section(di, d);
    const auto two = SampledSections(strayed, 1e-2, true).section(di, d);
    ASSERT_TRUE(one && two);
    EXPECT_EQ(one->sigma.value, two->sigma.value);
    EXPECT_EQ(one->sigma.bound, two->sigma.bound);
  }
}

TEST(SampledSections, CountFrontsOnlyWhereBacksReturnNothing) {
  Target target = target_of(two_spheres(), lambert(0.5));
  target.sides = Sides::front;
  expect_honest(target, 2e-2, false, 5);
  for (auto& f : target.mesh.facets) std::swap(f[0], f[1]);
  measure_facets(target.mesh);
  const Vec3 d = Vec3(1, 2, 3).normalized();
  EXPECT_FALSE(SampledSections(target, 2e-2, false).section(d, d)) << "nothing returns: exact";
}

TEST(SampledSections, DoNotTrustRaysBetweenSheetsThatLieOnEachOther) {
  FacetMesh mesh;
  add_tiled_plate(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 60);
  add_tiled_plate(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 60);
  Target target = target_of(mesh, lambert(0.8));
  target.materials.push_back({"black", lambert(0.1), 0.0, ""});
  for (std::size_t f = target.mesh.size() / 2; f < target.mesh.size(); ++f) target.material[f] = 1;
  const Vec3 d = Vec3(0.2, 0.1, 1.0).normalized(), other = Vec3(0.3, -0.1, 1.0).normalized();
  EXPECT_FALSE(SampledSections(target, 2e-2, true).section(d, other));
  target.material.assign(target.mesh.size(), 0);
  EXPECT_TRUE(SampledSections(target, 2e-2, true).section(d, other)) << "of one material it does not matter which";
}

TEST(SampledSections, DrawTheSameOfTwoEqualSheetsAsTheExactWayCounts) {
  FacetMesh mesh;
  add_tiled_plate(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 60);
  add_tiled_plate(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 60);
  for (std::size_t f = mesh.size() / 2; f < mesh.size(); ++f) std::swap(mesh.facets[f][0], mesh.facets[f][1]);
  Target target = target_of(mesh, lambert(0.8));
  target.sides = Sides::front;
  const Visibility visibility(target.mesh);
  for (const Vec3& toward : {Vec3(0.2, 0.1, 1.0), Vec3(0.3, 0.1, -1.0)}) {
    const Vec3 d = toward.normalized();
    const auto section = SampledSections(target, 2e-2, false).section(d, d);
    ASSERT_TRUE(section);
    EXPECT_LE(std::abs(section->sigma.value - cross_section(target, visibility, d, d).sigma.value),
              section->sigma.bound);
  }
}

TEST(SampledSections, AreNotWorthwhileForFineAccuracyOrFewFacets) {
  const Target target = target_of(two_spheres(), lambert(0.5));
  EXPECT_TRUE(SampledSections::may_pay(target, 1e-2));
  EXPECT_TRUE(SampledSections(target, 1e-2, false).may_pay());
  EXPECT_FALSE(SampledSections::may_pay(target, 1e-5));
  EXPECT_FALSE(SampledSections(target, 1e-4, false).may_pay()) << "few outlines: exact is fast";
  EXPECT_FALSE(SampledSections(target_of(revolved({{1.0, 0.0}, {0.2, 0.5}, {1.0, 1.0}}, 12), lambert(0.5)), 1e-2, false)
                   .may_pay());
}

// One box of many facets stands on another, of another material, and a third beside them touches both.
Target touching_boxes() {
  FacetMesh mesh;
  const auto add_tiled_box = [&](const Vec3& low, const Vec3& s) {
    const Vec3 x(s.x(), 0, 0), y(0, s.y(), 0), z(0, 0, s.z());
    for (const auto& [p, u, v] : {std::array{low, y, x},
                                  {Vec3(low + z), x, y},
                                  {low, x, z},
                                  {Vec3(low + y), z, x},
                                  {low, z, y},
                                  {Vec3(low + x), y, z}})
      add_tiled_plate(mesh, p, u, v, 40);
  };
  add_tiled_box({0, 0, 0}, {1, 1, 0.5});
  add_tiled_box({0.2, 0.3, 0.5}, {0.5, 0.6, 0.8});
  add_tiled_box({1, 0, 0}, {0.4, 1, 1});
  Target target = target_of(mesh, library("metal-skin-5p"));
  target.materials.push_back({"white", lambert(0.9), 0.0, ""});
  for (std::size_t f = mesh.size() / 3; f < 2 * mesh.size() / 3; ++f) target.material[f] = 1;
  return target;
}

TEST(SampledSections, AreHonestAboutBoxesThatTouchAndDoNotDoubtWhatTheyHide) {
  for (const Sides sides : {Sides::both, Sides::front}) {
    Target target = touching_boxes();
    target.sides = sides;
    for (const bool bistatic : {false, true}) expect_honest(target, 3e-2, bistatic, 6);
  }
}

TEST(SampledSections, AreHonestAboutPartsThatPassThroughEachOther) {
  FacetMesh mesh = sphere(1.0, 60);
  append(mesh, sphere(0.9, 60), {0.4, 0.3, 0.2});
  append(mesh, sphere(0.3, 30), {-0.9, 0.0, 0.2});
  Target target = target_of(mesh, lambert(0.5));
  target.materials.push_back({"metal", library("metal-skin-5p"), 0.0, ""});
  for (std::size_t f = 0; f < mesh.size(); f += 3) target.material[f] = 1;
  for (const bool bistatic : {false, true}) expect_honest(target, 2e-2, bistatic, 7);
}

// Too small for sampling to pay: the grids themselves, drawn and cast.
TEST(SampledSections, HaveHonestBoundsForATriangleSoup) {
  std::mt19937_64 random(8);
  const Target target = target_of(random_soup(random, 300), library("metal-skin-5p"));
  const Visibility visibility(target.mesh);
  const RowGrids grids(target.mesh);
  const EmbreeScene scene(target.mesh);
  const TouchingFacets touching(target, scene);
  RowSums cast(target, scene, touching);
  DrawnSums drawn(target);
  for (int k = 0; k < 20; ++k) {
    const Vec3 dr = random_direction(random), di = (dr + random_direction(random)).normalized();
    for (const double size : {32.0, 128.0}) {
      const RowGrid grid = grids.over(dr, size);
      const double side = grid.step / grids.placement().scale, around = 4.0 * std::numbers::pi * side * side;
      const auto expect_within = [&](const RowTotal& sum, const Vec3& to_transmitter) {
        const double truth = cross_section(target, visibility, to_transmitter, dr).sigma.value;
        EXPECT_LE(std::abs(around * sum.value - truth), around * sum.bound()) << k << ' ' << size;
      };
      expect_within(sum_of_rows(drawn.draw(grid), drawn.largest()), dr);
      expect_within(sum_of_rows(cast.cast(grid, di), cast.largest()), di);
    }
  }
}

TEST(SampledSections, MakeASweepThatIsTheSameForAnyNumberOfThreadsAndIsCounted) {
  const Target target = target_of(two_spheres(), library("metal-skin-5p"));
  std::vector<Aspect> aspects;
  for (int k = 0; k < 12; ++k) aspects.push_back(aspect_of({30.0 * k, 11.0}, {}));
  MethodCounts methods;
  SweepWatch watch;
  watch.wants_facets = [](std::size_t row) { return row == 3; };
  watch.facets = [](std::size_t, const SweepRow&, const CrossSection&) {};
  const auto one = run_sweep(target, aspects, 1, watch, nullptr, 1e-2, &methods);
  const auto two = run_sweep(target, aspects, 2, watch, nullptr, 1e-2);
  EXPECT_GE(methods.exact, 1U) << "the row whose facets are wanted";
  EXPECT_GT(methods.sampled, 6U);
  EXPECT_EQ(methods.exact + methods.sampled, aspects.size());
  const auto exact = run_sweep(target, aspects, 2);
  for (std::size_t k = 0; k < aspects.size(); ++k) {
    EXPECT_EQ(one[k].sigma.value, two[k].sigma.value);
    EXPECT_EQ(one[k].sigma.bound, two[k].sigma.bound);
    EXPECT_EQ(one[k].seen_area, two[k].seen_area);
    EXPECT_LE(std::abs(one[k].sigma.value - exact[k].sigma.value), one[k].sigma.bound);
  }
  EXPECT_EQ(one[3].sigma.value, exact[3].sigma.value);
}

TEST(SampledSections, LeaveABlackTargetToTheExactWay) {
  const Target target = target_of(two_spheres(), lambert(0.0));
  MethodCounts methods;
  const auto rows = run_sweep(target, {aspect_of({10.0, 20.0}, {})}, 1, {}, nullptr, 1e-2, &methods);
  EXPECT_EQ(rows[0].sigma.value, 0.0);
  EXPECT_EQ(methods.exact, 1U);
}

}  // namespace
}  // namespace lrcs
