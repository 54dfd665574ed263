#include "lrcs/convex_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "lrcs/convexity.h"
#include "lrcs/retro_sums.h"
#include "tests/lrcs/convex_sigma.h"
#include "tests/lrcs/test_targets.h"

namespace lrcs {
namespace {

Brdf mirrored() {
  WuParameters<double> p = std::get<Wu>(library("painted-steel-9p")).parameters();
  p.azimuth_of_specular = 0;
  return Wu(p);
}

FacetMesh box_of(int n) {  // each face in 2 n n facets
  FacetMesh mesh;
  const auto face = [&](const Vec3& p, const Vec3& u, const Vec3& v) {
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) add_plate(mesh, p + u * i + v * j, u, v);
  };
  const double s = 1.0;
  const Vec3 low(0, 0, 0), x(s, 0, 0), y(0, s, 0), z(0, 0, s);
  face(low, y, x), face(low + n * z, x, y);
  face(low, x, z), face(low + n * y, z, x);
  face(low, z, y), face(low + n * x, y, z);
  return mesh;
}

// An ellipsoid of four materials in patches, one of them black.
Target motley() {
  FacetMesh mesh = icosphere(3);
  for (Vec3& p : mesh.positions) p = p.cwiseProduct(Vec3(1.0, 0.5, 0.25));
  Target target = target_of(std::move(mesh), library("metal-skin-5p"));
  for (const Brdf& brdf : {lambert(0.5), lambert(0.0), mirrored()}) target.materials.push_back({"m", brdf, 0.0, ""});
  for (std::size_t k = 0; k < target.mesh.size(); ++k) target.material[k] = k / 100 % 4;
  return target;
}

ConvexBody::Section section_by_blocks(const Target& target, const Vec3& di, const Vec3& dr) {
  const ConvexBody body(target);
  std::vector<std::uint8_t> faced(body.blocks(), 0);
  return body.sections(std::vector<Aspect>{{{}, {}, di, dr}}, faced)[0];
}

void expect_same(const Target& target, const Vec3& di, const Vec3& dr) {
  ASSERT_TRUE(is_convex_body(target.mesh));
  const CrossSection sought = section_of(target, di, dr);
  const auto quick = section_by_blocks(target, di, dr);
  EXPECT_NEAR(quick.sigma.value, sought.sigma.value, 1e-14 * sought.sigma.value);
  EXPECT_NEAR(quick.seen_area, sought.seen_area, 1e-14 * sought.seen_area);
  // Faces exactly edge-on are in this bound, as if they were not exactly so.
  EXPECT_LE(quick.sigma.bound, 8.0 * sought.sigma.bound);
}

TEST(ConvexBody, GivesWhatVisibilityGives) {
  std::mt19937_64 random(61);
  std::vector<Target> targets{motley(), target_of(box_of(3), library("painted-steel-9p"))};
  for (const Brdf& brdf : {lambert(0.7), mirrored(), library("metal-skin-9p")})
    targets.push_back(target_of(icosphere(2), brdf));
  for (const Target& target : targets)
    for (int round = 0; round < 10; ++round) {
      const Vec3 d = random_direction(random);
      expect_same(target, d, d);
      expect_same(target, d, random_direction(random));
    }
}

TEST(ConvexBody, GivesWhatVisibilityGivesAlongAxesWhereFacesAreEdgeOn) {
  const Target box = target_of(box_of(4), library("metal-skin-5p"));
  for (const Vec3& d : {Vec3(1, 0, 0), Vec3(0, 0, -1), Vec3(0.6, 0.8, 0.0)}) {
    expect_same(box, d, d);
    expect_same(box, d, Vec3(0, 0.6, 0.8));
  }
}

TEST(ConvexBody, BoundHoldsAgainstExtendedPrecision) {
  std::mt19937_64 random(62);
  const Target target = motley();
  for (int round = 0; round < 50; ++round) {
    const Vec3 di = random_direction(random), dr = round % 2 == 0 ? di : random_direction(random);
    const auto section = section_by_blocks(target, di, dr);
    const long double truth = convex_sigma(target, di, dr);
    EXPECT_LE(std::abs(static_cast<double>(section.sigma.value - truth)), section.sigma.bound);
    EXPECT_LE(section.sigma.bound, 1e-9 * section.sigma.value);
  }
}

// Wu's diffuse term jumps where a face is seen edge-on (docs/methods.md, section 2).
TEST(ConvexBody, BoundHoldsTheJumpOfAFacePerhapsEdgeOn) {
  const Target target = target_of(box_of(1), library("metal-skin-5p"));
  const double kd = std::get<Wu>(target.materials[0].brdf).parameters().kd;
  const Vec3 dr = Vec3(1, 1, 1).normalized();
  const double jump = 4.0 * std::numbers::pi * kd * dr.x();
  const auto perhaps = section_by_blocks(target, Vec3(0x1p-60, 0.6, 0.8), dr).sigma;
  EXPECT_GE(perhaps.bound, (1.0 - 1e-6) * jump);
  const auto exactly = section_by_blocks(target, Vec3(0, 0.6, 0.8), dr).sigma;
  EXPECT_LE(exactly.bound, 1e-12);
}

TEST(ConvexBody, GivesTheSameBytesWhateverIsAskedTogether) {
  const Target target = motley();
  const ConvexBody body(target);
  std::vector<Aspect> aspects;
  for (int k = 0; k < 20; ++k) aspects.push_back(aspect_of({17.0 * k, 3.0 * k}, {}));
  std::vector<std::uint8_t> faced(body.blocks(), 0);
  const auto together = body.sections(aspects, faced);
  for (std::size_t k = 0; k < aspects.size(); ++k) {
    const auto alone = body.sections(std::span(aspects).subspan(k, 1), faced)[0];
    EXPECT_EQ(alone.sigma.value, together[k].sigma.value);
    EXPECT_EQ(alone.sigma.bound, together[k].sigma.bound);
    EXPECT_EQ(alone.seen_area, together[k].seen_area);
  }
}

// The same operations one by one, in code for any machine: what every vector version must give, to the byte.
template <class Form>
LaneSums one_by_one(const FacetBlock& block, const Vec3& d, const Form& form) {
  LaneSums sums;
  for (std::size_t k = 0; k < block_facets; ++k) {
    const double along = std::min(block.cosine(k, d), 1.0), cosine = std::max(along, 0.0);
    const double all = block.area[k] * form(std::max(along, smallest_retro_cosine));
    const double returns = along > -doubtful_cosine ? all : 0.0;
    sums.returned[k] = returns * cosine;
    sums.seen[k] = block.area[k] * cosine;
    sums.slope[k] = returns;
  }
  return sums;
}

template <class Form>
void expect_same_bytes(const FacetBlock& block, const Vec3& d, const Form& form) {
  const LaneSums plain = one_by_one(block, d, form);
  std::vector<bool> ways{false};
  if (block.least(d) >= smallest_retro_cosine) ways.push_back(true);
  for (const bool all_lit : ways) {
    LaneSums wide;
    add_retro(block, d, all_lit, form, wide);
    EXPECT_EQ(wide.returned, plain.returned);
    EXPECT_EQ(wide.seen, plain.seen);
    EXPECT_EQ(wide.slope, plain.slope);
  }
}

TEST(RetroSums, AreTheSameBytesAsOneByOne) {
  std::mt19937_64 random(63);
  std::uniform_real_distribution<double> area(0.0, 2.0);
  int all_lit = 0;
  for (int round = 0; round < 200; ++round) {
    FacetBlock block;
    block.low = Vec3::Constant(2.0), block.high = Vec3::Constant(-2.0);
    const Vec3 middle = random_direction(random), d = random_direction(random);
    for (std::size_t k = 0; k < block_facets; ++k) {
      const Vec3 n = (middle + (round % 2 == 0 ? 0.1 : 3.0) * random_direction(random)).normalized();
      block.nx[k] = n.x(), block.ny[k] = n.y(), block.nz[k] = n.z(), block.area[k] = area(random);
      block.low = block.low.cwiseMin(n), block.high = block.high.cwiseMax(n);
    }
    expect_same_bytes(block, d, *retro_form(std::get<Wu>(library("metal-skin-9p"))));
    expect_same_bytes(block, d, *retro_form(Lambert(0.3)));
    expect_same_bytes(block, d, BlackRetro());
    for (std::size_t k = 0; k < block_facets; ++k) {
      EXPECT_LE(block.least(d), block.cosine(k, d));
      EXPECT_GE(block.most(d), block.cosine(k, d));
    }
    all_lit += block.least(d) >= smallest_retro_cosine ? 1 : 0;
  }
  EXPECT_GT(all_lit, 20);
}

}  // namespace
}  // namespace lrcs
