// What a sweep skips: the rows are those of the same directions computed one at a time, where there is nothing to skip,
// and the counts are those of known cases.
#include "lrcs/skips.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lrcs/sweep.h"
#include "tests/lrcs/test_targets.h"

namespace lrcs {
namespace {

std::vector<Aspect> round_the_target(double step_deg, double elevation_deg, const Receiver& receiver = {}) {
  std::vector<Aspect> aspects;
  for (double azimuth = 0.0; azimuth <= 360.0; azimuth += step_deg)
    aspects.push_back(aspect_of({azimuth, elevation_deg}, receiver));
  return aspects;
}

SkipCounts expect_rows_as_one_by_one(const Target& target, const std::vector<Aspect>& aspects) {
  SkipCounts skipped;
  const auto rows = run_sweep(target, aspects, 2, {}, &skipped);
  const Visibility visibility(target.mesh);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const CrossSection alone = cross_section(target, visibility, aspects[k].to_transmitter, aspects[k].to_receiver);
    EXPECT_LE(std::abs(rows[k].sigma.value - alone.sigma.value), rows[k].sigma.bound + alone.sigma.bound) << k;
    EXPECT_NEAR(rows[k].sigma.value, alone.sigma.value, 1e-12 * alone.sigma.value) << k;
    EXPECT_NEAR(rows[k].seen_area, alone.seen_area, 1e-12 * alone.seen_area) << k;
    EXPECT_EQ(rows[k].aspect.transmitter, aspects[k].transmitter);
  }
  return skipped;
}

// Symmetric in y, by its facets too, and not convex: a gable on a gable.
Target gables() {
  FacetMesh mesh;
  const auto gable = [&](double size, double z) {
    const Vec3 front(size, 0, z + size), back(-size, 0, z + size);
    for (const double side : {1.0, -1.0}) {
      const Vec3 a(size, side * size, z), b(-size, side * size, z);
      add_triangle(mesh, a, side > 0.0 ? front : b, side > 0.0 ? b : front);
      add_triangle(mesh, b, side > 0.0 ? front : back, side > 0.0 ? back : front);
    }
  };
  gable(3.0, 0.0);
  gable(1.0, 2.5);
  return target_of(mesh, library("painted-steel-5p"));
}

TEST(Skips, RepeatedAndMirroredDirectionsAreComputedOnce) {
  const SkipCounts skipped = expect_rows_as_one_by_one(gables(), round_the_target(10.0, 25.0));
  EXPECT_EQ(skipped.mirror_planes, "y");
  EXPECT_EQ(skipped.repeated_directions, 1U);   // 360
  EXPECT_EQ(skipped.mirrored_directions, 17U);  // 190 to 350
  EXPECT_EQ(skipped.monostatic_directions, 19U);
  EXPECT_EQ(skipped.fixed_gamma_directions, 0U);
  EXPECT_EQ(skipped.convex_facets, 0U);
}

TEST(Skips, BistaticImagesMustMirrorTheReceiverToo) {
  Receiver in_plane;
  in_plane.kind = Receiver::Kind::fixed;
  in_plane.fixed = {0.0, 40.0};
  EXPECT_EQ(expect_rows_as_one_by_one(gables(), round_the_target(10.0, 25.0, in_plane)).mirrored_directions, 17U);
  Receiver aside = in_plane;
  aside.fixed = {5.0, 40.0};
  const SkipCounts skipped = expect_rows_as_one_by_one(gables(), round_the_target(10.0, 25.0, aside));
  EXPECT_EQ(skipped.mirrored_directions, 0U);
  EXPECT_EQ(skipped.repeated_directions, 1U);
  EXPECT_EQ(skipped.fixed_gamma_directions, 36U);
}

TEST(Skips, AConvexTargetNeedsNoVisibility) {
  const Target target = target_of(icosphere(3), library("metal-skin-9p"));
  const SkipCounts skipped = expect_rows_as_one_by_one(target, round_the_target(30.0, 10.0));
  EXPECT_EQ(skipped.convex_facets, 1280U);
  EXPECT_EQ(skipped.repeated_directions, 1U);
  EXPECT_EQ(skipped.monostatic_directions, 12U);
  Target dented = target;
  dented.mesh.positions[50] *= 0.9;
  measure_facets(dented.mesh);
  EXPECT_EQ(expect_rows_as_one_by_one(dented, round_the_target(30.0, 10.0)).convex_facets, 0U);
}

TEST(Skips, FacetsThatNoDirectionFacesAreLeftOut) {
  // Each face of a box in 128 facets: two blocks. Seen from the right front and above: three faces are never faced.
  FacetMesh mesh;
  const auto face = [&](const Vec3& p, const Vec3& u, const Vec3& v) {
    for (int i = 0; i < 8; ++i)
      for (int j = 0; j < 8; ++j) add_plate(mesh, p + i * u + j * v, u, v);
  };
  const Vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), low(0, 0, 0);
  face(low, y, x), face(low, x, z), face(low, z, y);
  face(8 * z, x, y), face(8 * y, z, x), face(8 * x, y, z);
  std::vector<Aspect> aspects;
  for (const double azimuth : {20.0, 40.0, 60.0}) aspects.push_back(aspect_of({azimuth, 30.0}, {}));
  const Target target = target_of(mesh, lambert(0.5));
  EXPECT_EQ(expect_rows_as_one_by_one(target, aspects).facets_never_faced, 3U * 128U);
  aspects.push_back(aspect_of({200.0, -30.0}, {}));
  EXPECT_EQ(expect_rows_as_one_by_one(target, aspects).facets_never_faced, 0U);
}

Target two_boxes() {
  FacetMesh mesh;
  add_box(mesh, {0, 0, 0}, {1, 1, 1});
  add_box(mesh, {3, 0, 0}, {4, 1, 1});
  return target_of(mesh, lambert(0.5));
}

TEST(Skips, HullFacetsAndFreePartsAreCountedOverRowsAndViewers) {
  std::vector<Aspect> aspects;
  // Along x one box stands before the other; along y none does.
  for (const double azimuth : {0.0, 90.0, 180.0, -90.0}) aspects.push_back(aspect_of({azimuth, 10.0}, {}));
  const SkipCounts skipped = expect_rows_as_one_by_one(two_boxes(), aspects);
  EXPECT_EQ(skipped.hull_facets, 20U);
  EXPECT_EQ(skipped.mirror_planes, "");
  EXPECT_EQ(skipped.free_convex_parts, 1U + 2U + 1U + 2U);
  EXPECT_EQ(skipped.parts_apart, 0U);
  Receiver above;
  above.kind = Receiver::Kind::fixed;
  above.fixed = {90.0, 80.0};
  EXPECT_EQ(expect_rows_as_one_by_one(two_boxes(), {aspect_of({0.0, 10.0}, above)}).free_convex_parts, 1U + 2U);
}

TEST(Skips, FacetsOfSolidsThatNoDirectionFacesAreLeftOutWhereDirectionsAreMany) {
  std::vector<Aspect> aspects;
  for (double azimuth = 20.0; azimuth <= 70.0; azimuth += 0.125) aspects.push_back(aspect_of({azimuth, 30.0}, {}));
  // Of each box three faces are never faced.
  EXPECT_EQ(expect_rows_as_one_by_one(two_boxes(), aspects).facets_never_faced, 2U * 6U);
  aspects.resize(10);
  EXPECT_EQ(expect_rows_as_one_by_one(two_boxes(), aspects).facets_never_faced, 0U);
  EXPECT_EQ(expect_rows_as_one_by_one(gables(), round_the_target(2.0, 25.0)).facets_never_faced, 0U);
}

TEST(Skips, FacetsOfABlackMaterialBlockAndAreSeenButReturnNothing) {
  Target target = gables();
  WuParameters<double> dark = std::get<Wu>(target.materials[0].brdf).parameters();
  dark.kb = dark.kd = 0.0;
  target.materials.push_back({"dark", Wu(dark), 0.0, ""});
  for (std::size_t k = 4; k < 8; ++k) target.material[k] = 1;
  EXPECT_EQ(expect_rows_as_one_by_one(target, round_the_target(40.0, 30.0)).facets_without_return, 4U);
  const Vec3 up(0, 0, 1);
  const CrossSection section = section_of(target, up, up);
  EXPECT_NEAR(section.seen_area, 36.0, 1e-12);
  for (std::size_t k = 4; k < 8; ++k) {
    EXPECT_EQ(section.facet_sigma[k], 0.0);
    EXPECT_EQ(section.seen_fraction[k], 1.0);
  }
}

TEST(Skips, ARowWhoseFacetsAreWantedIsComputedByItself) {
  for (const Target& target : {gables(), target_of(icosphere(2), library("metal-skin-5p"))}) {
    const auto aspects = round_the_target(90.0, 20.0);
    std::vector<CrossSection> sections(aspects.size());
    SkipCounts skipped;
    const auto rows = run_sweep(target, aspects, 2,
                                {{},
                                 [](std::size_t row) { return row % 2 == 0; },
                                 [&](std::size_t row, const SweepRow&, const CrossSection& s) { sections[row] = s; }},
                                &skipped);
    EXPECT_EQ(skipped.repeated_directions, 0U);  // 360 is wanted
    for (const std::size_t k : {0U, 2U, 4U}) {
      const CrossSection alone = section_of(target, aspects[k].to_transmitter, aspects[k].to_receiver);
      EXPECT_EQ(sections[k].sigma.value, alone.sigma.value);
      EXPECT_EQ(sections[k].seen_fraction, alone.seen_fraction);
      EXPECT_EQ(rows[k].sigma.value, sections[k].sigma.value);
    }
  }
}

}  // namespace
}  // namespace lrcs
