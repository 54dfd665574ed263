// Facets whose backs have a material of their own: in every way that a cross section is computed.
#include <gtest/gtest.h>

#include <numbers>

#include "lrcs/facet_returns.h"
#include "lrcs/mirror_planes.h"
#include "lrcs/sampled_sections.h"
#include "lrcs/sweep.h"
#include "tests/lrcs/honest_samples.h"
#include "tests/lrcs/test_targets.h"

namespace lrcs {
namespace {

constexpr double bright = 0.8, dim = 0.3;

// Fronts are bright, backs dim.
Target two_sided(FacetMesh mesh) {
  Target target = target_of(std::move(mesh), lambert(bright));
  target.materials.push_back({"back", lambert(dim), 0.0, ""});
  target.back.assign(target.mesh.size(), 1);
  return target;
}

// What it is from the other side of the paper: the same surface.
Target turned_over(Target target) {
  target.mesh = reversed(target.mesh);
  measure_facets(target.mesh);
  const auto front = target.material;
  target.material = target.back_material();
  target.back = front;
  return target;
}

FacetMesh sheet() {
  FacetMesh mesh;
  add_plate(mesh, {-1, -0.5, 0}, {2, 0, 0}, {0, 1, 0});
  return mesh;
}

// Two bowls, one before the other: many facets, so that sampling pays, and insides to look into.
FacetMesh bowls() {
  std::vector<std::pair<double, double>> half;
  for (int k = 0; k <= 60; ++k) {
    const double t = 0.5 * std::numbers::pi * k / 60;
    half.emplace_back(k == 0 ? 0.0 : std::sin(t), -std::cos(t));
  }
  const FacetMesh one = revolved(half, 120);
  FacetMesh mesh = one;
  append(mesh, one, {1.2, 0.3, 0.2});
  return mesh;
}

TEST(TwoSides, OfALambertSheetReturnWhatTheirOwnFormulaSays) {
  const Target target = two_sided(sheet());
  constexpr double area = 2.0;
  std::mt19937_64 random(71);
  for (int k = 0; k < 50; ++k) {
    const Vec3 di = random_direction(random), dr = k % 2 == 0 ? di : random_direction(random);
    const double expected = di.z() * dr.z() <= 0.0 ? 0.0 : 4.0 * (di.z() > 0.0 ? bright : dim) * area * di.z() * dr.z();
    const Estimate sigma = section_of(target, di, dr).sigma;
    EXPECT_NEAR(sigma.value, expected, 1e-13);
    EXPECT_LE(std::abs(sigma.value - expected), sigma.bound + 1e-30);
  }
}

TEST(TwoSides, OfFacetsReturnTheirOwnWhereTheyAreSampled) {
  const Target target = two_sided(sheet());
  FacetReturns returns(target);
  for (const double side : {1.0, -1.0}) {
    const Vec3 di = side * Vec3(1, 2, 3).normalized(), dr = side * Vec3(2, 1, 5).normalized();
    const double reflectance = side > 0.0 ? bright : dim;
    returns.look_along(dr, dr);
    EXPECT_DOUBLE_EQ(returns.of(0), reflectance / std::numbers::pi * std::abs(dr.z()));
    returns.look_along(di, dr);
    EXPECT_DOUBLE_EQ(returns.of(0), reflectance / std::numbers::pi * std::abs(di.z()));
    EXPECT_DOUBLE_EQ(returns.most(0), returns.of(0));
  }
}

TEST(TwoSides, ChangeNothingWhereTheyAreAlike) {
  std::mt19937_64 random(72);
  const Target target = target_of(random_soup(random, 60), library("painted-steel-9p"));
  Target said = target;
  said.back = said.material;
  for (int k = 0; k < 10; ++k) {
    const Vec3 di = random_direction(random), dr = k % 2 == 0 ? di : random_direction(random);
    const CrossSection one = section_of(target, di, dr), other = section_of(said, di, dr);
    EXPECT_EQ(one.sigma.value, other.sigma.value);
    EXPECT_EQ(one.sigma.bound, other.sigma.bound);
  }
}

TEST(TwoSides, AreTheSameSurfaceWithFacetsTurnedAndMaterialsExchanged) {
  std::mt19937_64 random(73);
  Target target = two_sided(random_soup(random, 60));
  target.materials.push_back({"gloss", library("painted-steel-9p"), 0.0, ""});
  for (std::size_t f = 0; f < target.mesh.size(); ++f) {
    target.material[f] = f % 3;
    target.back[f] = (f / 3) % 3;
  }
  const Target other = turned_over(target);
  for (int k = 0; k < 20; ++k) {
    const Vec3 di = random_direction(random), dr = k % 2 == 0 ? di : random_direction(random);
    const Estimate a = section_of(target, di, dr).sigma, b = section_of(other, di, dr).sigma;
    EXPECT_NEAR(a.value, b.value, a.bound + b.bound);
    EXPECT_NEAR(a.value, b.value, 1e-12 * a.value);
  }
}

TEST(TwoSides, AreWhatTwoOppositeFacetsOnEachOtherWere) {
  FacetMesh pair = sheet();
  append(pair, reversed(sheet()));
  Target opposite = target_of(std::move(pair), lambert(bright));
  opposite.materials.push_back({"back", lambert(dim), 0.0, ""});
  opposite.material = {0, 0, 1, 1};
  const Target target = two_sided(sheet());
  std::mt19937_64 random(74);
  for (int k = 0; k < 20; ++k) {
    const Vec3 di = random_direction(random), dr = k % 2 == 0 ? di : random_direction(random);
    EXPECT_NEAR(section_of(opposite, di, dr).sigma.value, section_of(target, di, dr).sigma.value, 1e-13);
  }
}

TEST(TwoSides, BothBoundWhatAFacetMayReturnThatIsEdgeOnAsFarAsDoublesTell) {
  FacetMesh mesh;
  const Vec3 u = Vec3(1, 2, 3).normalized(), v = Vec3(3, -1, 0.7).normalized();
  add_triangle(mesh, Vec3::Zero(), u, v);
  const Target target = two_sided(mesh), other = turned_over(target);
  const Vec3 n = target.mesh.normals[0];
  const Vec3 di = (u + 0.5 * v).normalized();
  for (const double side : {1.0, -1.0}) {
    const Vec3 dr = (0.3 * di + side * n).normalized();
    const Estimate a = section_of(target, di, dr).sigma, b = section_of(other, di, dr).sigma;
    EXPECT_EQ(a.value, 0.0);
    EXPECT_GT(a.bound, 0.0);
    EXPECT_EQ(a.bound, b.bound);
    FacetReturns returns(target), of_other(other);
    returns.look_along(di, dr);
    of_other.look_along(di, dr);
    EXPECT_EQ(returns.most(0), of_other.most(0));
  }
}

TEST(TwoSides, AreSampledWithinTheirBound) {
  for (const bool bistatic : {false, true}) expect_honest(two_sided(bowls()), 2e-2, bistatic, 75);
}

TEST(TwoSides, OfALambertSheetAreSampledToItsFormula) {
  FacetMesh mesh;
  add_tiled_plate(mesh, {-1, -0.5, 0}, {2, 0, 0}, {0, 1, 0}, 100);
  const Target target = two_sided(mesh);
  constexpr double relative = 2e-2, area = 2.0;
  const SampledSections sampled(target, relative, true);
  for (const double side : {1.0, -1.0}) {
    const Vec3 dr = side * Vec3(1, 2, 5).normalized(), di = side * Vec3(2, -1, 4).normalized();
    for (const Vec3& from : {dr, di}) {
      const auto section = sampled.section(from, dr);
      ASSERT_TRUE(section);
      const double expected = 4.0 * (side > 0.0 ? bright : dim) * area * std::abs(from.z() * dr.z());
      EXPECT_NEAR(section->sigma.value, expected, section->sigma.bound);
      EXPECT_LE(section->sigma.bound, relative * expected * (1.0 + relative));
    }
  }
}

TEST(TwoSides, AreCountedToReturnNothingOnlyIfBothDo) {
  Target target = two_sided(sheet());
  target.materials.push_back({"black", lambert(0.0), 0.0, ""});
  const std::vector<Aspect> aspects{aspect_of({10.0, 50.0}, {})};
  const auto count = [&](std::uint32_t front, std::uint32_t back) {
    target.material.assign(2, front);
    target.back.assign(2, back);
    SkipCounts skipped;
    (void)run_sweep(target, aspects, 1, {}, &skipped);
    return skipped.facets_without_return;
  };
  EXPECT_EQ(count(2, 2), 2U);
  EXPECT_EQ(count(2, 1), 0U);
  EXPECT_EQ(count(0, 2), 0U);
}

// Two leaves, images of each other in the plane y = 0, and one that crosses it.
Target leaves() {
  FacetMesh mesh;
  add_triangle(mesh, {0, 1, 0}, {1, 2, 0.5}, {0, 2, 1});
  add_triangle(mesh, {0, -1, 0}, {0, -2, 1}, {1, -2, 0.5});
  add_triangle(mesh, {3, -1, 0}, {3, 1, 0}, {4, 0, 1});
  return two_sided(mesh);
}

TEST(TwoSides, AreMirroredFrontToFrontAndBackToBack) {
  const MirrorPlanes sought{false, true, false};
  EXPECT_EQ(mirror_planes(leaves(), sought, {}), sought);
  Target other_back = leaves();
  other_back.back[0] = 0;
  EXPECT_EQ(mirror_planes(other_back, sought, {}), MirrorPlanes{});
  Target exchanged = leaves();
  std::swap(exchanged.material[0], exchanged.back[0]);
  EXPECT_EQ(mirror_planes(exchanged, sought, {}), MirrorPlanes{});
  std::vector<Aspect> aspects;
  for (const double azimuth : {20.0, -20.0, 130.0, -130.0, 200.0, 160.0})
    aspects.push_back(aspect_of({azimuth, -35.0}, {}));
  SkipCounts skipped;
  const auto rows = run_sweep(leaves(), aspects, 1, {}, &skipped);
  EXPECT_EQ(skipped.mirrored_directions, 3U);
  for (std::size_t k = 0; k < rows.size(); ++k)
    EXPECT_NEAR(rows[k].sigma.value,
                section_of(leaves(), aspects[k].to_transmitter, aspects[k].to_receiver).sigma.value, 1e-14);
}

// Of facets on one another the first is seen from both sides.
TEST(TwoSides, AreMirroredOnlyWhereFacetsOnEachOtherOfOtherBacksComeInTheSameOrder) {
  const Vec3 a(1, 1, 0), b(3, 1, 0), c(1, 3, 0), m(-1, 1, 1);
  for (const bool same_order : {true, false}) {
    FacetMesh mesh;
    for (int k = 0; k < 2; ++k) add_triangle(mesh, a, b, c);
    for (int k = 0; k < 2; ++k) add_triangle(mesh, a.cwiseProduct(m), c.cwiseProduct(m), b.cwiseProduct(m));
    Target target = two_sided(mesh);
    target.back = {0, 1, 0, 1};
    if (!same_order) std::swap(target.back[2], target.back[3]);
    EXPECT_EQ(mirror_planes(target, {true, false, false}, Visibility(target.mesh).coincident_facets())[0], same_order);
  }
}

}  // namespace
}  // namespace lrcs
