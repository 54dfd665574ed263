#include "lrcs/cross_section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <variant>

#include "base/compensated_sum.h"
#include "tests/lrcs/convex_sigma.h"
#include "tests/lrcs/test_targets.h"

namespace lrcs {
namespace {

TEST(CrossSection, BoundHoldsAgainstExtendedPrecision) {
  std::mt19937_64 random(41);
  for (const Material& material : material_library())
    for (int round = 0; round < 10; ++round) {
      FacetMesh body =
          round % 2 == 0 ? sphere(1.0, 10) : revolved({{0.0, 0.0}, {1.0, 0.0}, {1.0, 3.0}, {0.0, 3.0}}, 17);
      const Target target = target_of(std::move(body), material.brdf);
      const Vec3 di = random_direction(random);
      const Vec3 dr = round % 3 == 0 ? di : random_direction(random);
      const Estimate sigma = section_of(target, di, dr).sigma;
      const long double truth = convex_sigma(target, di, dr);
      EXPECT_LE(std::abs(static_cast<double>(sigma.value - truth)), sigma.bound) << material.name;
      EXPECT_LE(sigma.bound, 1e-9 * sigma.value) << material.name;
    }
}

TEST(CrossSection, BoundHoldsWhereTheShadowIsKnown) {
  // A unit plate under a roof that covers x < 1/3, seen from above.
  FacetMesh mesh;
  add_plate(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  add_plate(mesh, {-1, -1, 1}, {1.0 + 1.0 / 3.0, 0, 0}, {0, 3, 0});
  const CrossSection section = section_of(target_of(mesh, lambert(1.0)), {0, 0, 1}, {0, 0, 1});
  const double roof = 3.0 * (1.0 + 1.0 / 3.0);
  EXPECT_LE(std::abs(section.sigma.value - 4.0 * (roof + 2.0 / 3.0)), section.sigma.bound + 1e-15);
  EXPECT_LE(section.sigma.bound, 1e-11);
}

// Wu's diffuse term does not go to 0 with cos_i: where rounding cannot tell on which side of a facet the transmitter
// is, the bound holds what either side returns.
TEST(CrossSection, BoundHoldsTheJumpWhereAFacetIsSeenEdgeOn) {
  std::mt19937_64 random(45);
  const Wu wu = std::get<Wu>(library("metal-skin-5p"));
  for (int round = 0; round < 300; ++round) {
    const Vec3 di = random_direction(random), dr = random_direction(random);
    FacetMesh mesh;
    add_triangle(mesh, Vec3::Zero(), di, random_direction(random));
    const Target target = target_of(mesh, wu);
    const Vec3& n = target.mesh.normals[0];
    const Vec3 lit = n.dot(dr) > 0.0 ? n : Vec3(-n);
    const double jump = 4.0 * std::numbers::pi * target.mesh.areas[0] * wu.parameters().kd * lit.dot(dr);
    const Estimate sigma = section_of(target, di, dr).sigma;
    EXPECT_GE(sigma.value + sigma.bound, (1.0 - 1e-6) * jump);
    EXPECT_LE(sigma.value - sigma.bound, 0.0);
  }
}

TEST(CrossSection, BoundKnowsWhatASteepLobeMakesOfTheRoundingOfDirections) {
  FacetMesh plate;
  add_plate(plate, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  WuParameters<double> parameters;
  parameters.kb = 1.0, parameters.kr = 1.0, parameters.b = -1e12, parameters.a = 1.0, parameters.kd = 0.0;
  const Target target = target_of(plate, Wu(parameters));
  const Vec3 di(0, 0, 1), dr = Vec3(3e-6, 0, 1).normalized(), rounded = dr + Vec3(0x1p-70, 0, 0);
  const Estimate one = section_of(target, di, dr).sigma, other = section_of(target, di, rounded).sigma;
  EXPECT_NE(one.value, other.value);
  EXPECT_LE(std::abs(one.value - other.value), one.bound);
}

TEST(CrossSection, SharesSumToTheWhole) {
  std::mt19937_64 random(43);
  const Target target = target_of(random_soup(random, 300), library("metal-skin-9p"));
  const Vec3 d = random_direction(random);
  const CrossSection section = section_of(target, d, d);
  CompensatedSum sum;
  for (const double share : section.facet_sigma) sum.add(share);
  EXPECT_NEAR(sum.value(), section.sigma.value, 1e-14 * section.sigma.value);
}

TEST(CrossSection, GivesEveryFacetItsOwnMaterial) {
  FacetMesh mesh;
  add_plate(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  add_plate(mesh, {2, 0, 0}, {1, 0, 0}, {0, 1, 0});
  Target target = target_of(mesh, lambert(1.0));
  target.materials.push_back({"dark", lambert(0.25), 0.0, ""});
  target.material = {0, 0, 1, 1};
  EXPECT_NEAR(section_of(target, {0, 0, 1}, {0, 0, 1}).sigma.value, 4.0 * 1.25, 1e-14);
}

TEST(CrossSection, LetsOnlyOutwardSidesReflectWhereAskedButAllBlock) {
  FacetMesh mesh;
  add_plate(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});  // front up
  add_plate(mesh, {0, 0, 1}, {0, 1, 0}, {1, 0, 0});  // front down, above the first
  Target target = target_of(mesh, lambert(1.0));
  EXPECT_NEAR(section_of(target, {0, 0, 1}, {0, 0, 1}).sigma.value, 4.0, 1e-14);
  target.sides = Sides::front;
  EXPECT_EQ(section_of(target, {0, 0, 1}, {0, 0, 1}).sigma.value, 0.0);
}

TEST(CrossSection, MonostaticIsTheLimitOfBistatic) {
  std::mt19937_64 random(47);
  const Target target = target_of(random_soup(random, 60), library("painted-steel-5p"));
  const Vec3 d = random_direction(random);
  const Vec3 near = (d + 1e-9 * d.unitOrthogonal()).normalized();
  const double mono = section_of(target, d, d).sigma.value;
  EXPECT_NEAR(section_of(target, d, near).sigma.value, mono, 1e-5 * mono);
}

TEST(CrossSection, StaysFiniteAtGrazingAspects) {
  FacetMesh plate;
  add_plate(plate, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  for (const Material& material : material_library())
    for (const double theta : {89.0, 89.99, 89.9999, 90.0}) {
      const Vec3 d(std::sin(theta * degree), 0.0, std::cos(theta * degree));
      const CrossSection section = section_of(target_of(plate, material.brdf), d, d);
      EXPECT_TRUE(std::isfinite(section.sigma.value) && section.sigma.value >= 0.0);
      EXPECT_TRUE(std::isfinite(section.sigma.bound));
    }
}

}  // namespace
}  // namespace lrcs
