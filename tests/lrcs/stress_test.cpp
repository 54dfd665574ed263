// Targets that are hard on numbers, with answers known in closed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "lrcs/visibility.h"
#include "tests/lrcs/test_targets.h"

namespace lrcs {
namespace {

std::vector<Estimate> seen_along(const FacetMesh& mesh, const Vec3& d) {
  return Visibility(mesh).seen_fraction(d, d);
}

double seen_area_along(const FacetMesh& mesh, const Vec3& d) {
  return section_of(target_of(mesh, lambert(1.0)), d, d).seen_area;
}

// Of plate k of two facets.
double seen_of_plate(const std::vector<Estimate>& seen, std::size_t k) {
  return 0.5 * (seen[2 * k].value + seen[2 * k + 1].value);
}
double bound_of_plate(const std::vector<Estimate>& seen, std::size_t k) {
  return 0.5 * (seen[2 * k].bound + seen[2 * k + 1].bound);
}

TEST(Stress, AStackOfAThousandLayersShowsAStripOfEach) {
  FacetMesh mesh;
  constexpr std::size_t layers = 1000;
  constexpr double apart = 1.0 / 64.0;
  for (std::size_t k = 0; k < layers; ++k)
    add_plate(mesh, {0, 0, apart * static_cast<double>(k)}, Vec3::UnitX(), Vec3::UnitY());
  // Each plate moves by apart tan(theta) over the one below it, and leaves so much of it to be seen.
  for (const double slope : {0.0, 0.125, 4.0}) {
    const auto seen = seen_along(mesh, Vec3(slope, 0, 1).normalized());
    EXPECT_EQ(seen_of_plate(seen, layers - 1), 1.0);
    for (std::size_t k = 0; k + 1 < layers; ++k)
      ASSERT_NEAR(seen_of_plate(seen, k), apart * slope, bound_of_plate(seen, k) + 1e-15) << "layer " << k;
  }
}

TEST(Stress, OfThousandsOfCoincidentFacetsOnePairIsSeen) {
  FacetMesh mesh;
  constexpr std::size_t plates = 1500;
  const Vec3 u = Vec3(1, 2, 3).normalized(), v = u.cross(Vec3(3, 1, -1)).normalized();
  for (std::size_t k = 0; k < plates; ++k) add_plate(mesh, {0.1, 0.2, 0.3}, u, v);
  const auto seen = seen_along(mesh, u.cross(v).normalized());
  EXPECT_EQ(seen_of_plate(seen, 0), 1.0);
  for (std::size_t k = 1; k < plates; ++k) ASSERT_EQ(seen_of_plate(seen, k), 0.0);
}

TEST(Stress, AtGrazingAnglesTheUpperPlateStillHidesItsShare) {
  const double tangent = std::tan(89.9999 * std::numbers::pi / 180.0);
  for (const double share : {0.25, 0.5, 0.999}) {
    FacetMesh mesh;
    add_plate(mesh, Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY());
    add_plate(mesh, {0, 0, share / tangent}, Vec3::UnitX(), Vec3::UnitY());
    const auto seen = seen_along(mesh, Vec3(tangent, 0, 1).normalized());
    // The direction's slope and the upper plate's height are each rounded a few times, relative to themselves.
    EXPECT_NEAR(seen_of_plate(seen, 0), share, bound_of_plate(seen, 0) + 8.0 * 0x1p-53 * share);
    EXPECT_LT(bound_of_plate(seen, 0), 1e-6);
    EXPECT_EQ(seen_of_plate(seen, 1), 1.0);
  }
}

// Silhouettes of each step fall on edges of those behind it, whichever axis one looks along.
TEST(Stress, StairsSeenAlongAxesShowTheirTreadsAndRisers) {
  FacetMesh mesh;
  constexpr int steps = 40;
  for (int k = 0; k < steps; ++k) add_box(mesh, {double(k), 0, 0}, {double(k + 1), 1, double(steps - k)});
  EXPECT_NEAR(seen_area_along(mesh, Vec3::UnitX()), steps, 1e-12);
  EXPECT_NEAR(seen_area_along(mesh, -Vec3::UnitX()), steps, 1e-12);
  EXPECT_NEAR(seen_area_along(mesh, Vec3::UnitZ()), steps, 1e-12);
  EXPECT_NEAR(seen_area_along(mesh, Vec3::UnitY()), steps * (steps + 1) / 2.0, 1e-9);
  // Along the stairs' slope the edges of all steps fall on one another.
  EXPECT_NEAR(seen_area_along(mesh, Vec3(1, 0, 1).normalized()), std::sqrt(0.5) * 2.0 * steps, 1e-11);
}

TEST(Stress, AThousandTilesOfAMillimetreBeforeAPlateOfAKilometre) {
  FacetMesh mesh;
  add_plate(mesh, {-500, -500, 0}, {1000, 0, 0}, {0, 1000, 0});
  constexpr int tiles = 1000;
  for (int k = 0; k < tiles; ++k)
    add_plate(mesh, {0.002 * (k % 40) - 0.3, 0.002 * (k / 40) + 100.0, 0.5}, {0.001, 0, 0}, {0, 0.001, 0});
  const auto seen = seen_along(mesh, Vec3::UnitZ());
  EXPECT_NEAR(1.0 - seen_of_plate(seen, 0), tiles * 1e-6 / 1e6, bound_of_plate(seen, 0) + 1e-15);
  EXPECT_LT(bound_of_plate(seen, 0), 1e-8);
  for (std::size_t k = 1; k <= tiles; ++k) ASSERT_EQ(seen_of_plate(seen, k), 1.0);
}

TEST(Stress, AFanOfAThousandFacetsAboutOneVertexHidesWhatALidWould) {
  FacetMesh mesh;
  constexpr std::uint32_t rays = 1000;
  const auto tip = add_vertex(mesh, {0, 0, 1});
  for (std::uint32_t k = 0; k < rays; ++k) {
    const double a = 2.0 * std::numbers::pi * k / rays;
    add_vertex(mesh, {std::cos(a), std::sin(a), 1.0 + 1e-3 * std::sin(5.0 * a)});
  }
  for (std::uint32_t k = 0; k < rays; ++k) add_facet(mesh, tip, tip + 1 + k, tip + 1 + (k + 1) % rays);
  const std::size_t first = mesh.size();
  add_plate(mesh, {-2, -2, 0}, {4, 0, 0}, {0, 4, 0});
  const auto seen = seen_along(mesh, Vec3::UnitZ());
  for (std::size_t f = 0; f < first; ++f) ASSERT_EQ(seen[f].value, 1.0);
  const double lid = 0.5 * rays * std::sin(2.0 * std::numbers::pi / rays);
  EXPECT_NEAR(16.0 * seen_of_plate(seen, first / 2), 16.0 - lid, 16.0 * bound_of_plate(seen, first / 2) + 1e-13);
}

TEST(Stress, NeedlesOfAspectTenToTheTenthCastTheirShadow) {
  FacetMesh mesh;
  add_plate(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  for (int k = 0; k < 50; ++k)
    add_triangle(mesh, {-0.5, 0.01 * k + 0.1, 1}, {1.5, 0.01 * k + 0.1, 1}, {0.5, 0.01 * k + 0.1 + 2e-10, 1});
  const auto seen = seen_along(mesh, Vec3::UnitZ());
  // Each is 2 long and 2e-10 high; its share over the plate: three quarters of its area.
  EXPECT_NEAR(1.0 - seen_of_plate(seen, 0), 50 * 0.75 * 2e-10, bound_of_plate(seen, 0) + 1e-15);
  EXPECT_LT(bound_of_plate(seen, 0), 1e-11);
}

TEST(Stress, DenormalAndHugeCoordinatesGiveTheSameBits) {
  std::mt19937_64 random(4);
  std::uniform_int_distribution<int> whole(0, 63);
  FacetMesh mesh;
  const auto p = [&] { return Vec3(whole(random), whole(random), whole(random)); };
  for (int k = 0; k < 60; ++k) add_triangle(mesh, p(), p(), p());
  const Vec3 d = random_direction(random);
  const auto seen = seen_along(mesh, d);
  for (const int exponent : {-1074, -1030, -600, 300}) {
    SCOPED_TRACE(testing::Message() << "times 2^" << exponent);
    FacetMesh scaled = mesh;
    for (Vec3& q : scaled.positions)
      for (double& x : q) x = std::ldexp(x, exponent);
    const auto same = seen_along(scaled, d);
    for (std::size_t f = 0; f < mesh.size(); ++f) ASSERT_EQ(same[f].value, seen[f].value) << "facet " << f;
  }
}

TEST(Stress, FacetsOfNoAreaHideNothingAndAreNotSeen) {
  FacetMesh mesh;
  add_plate(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> real(0.0, 1.0);
  for (int k = 0; k < 200; ++k) {
    const Vec3 p(real(random), real(random), 1), q(real(random), real(random), 1);
    add_triangle(mesh, p, q, k % 2 == 0 ? p : Vec3(p + (q - p)));
  }
  const auto seen = seen_along(mesh, Vec3(0.2, 0.1, 1.0).normalized());
  for (const std::size_t f : {0, 1}) {
    EXPECT_NEAR(seen[f].value, 1.0, seen[f].bound + 1e-15);
    EXPECT_LT(seen[f].bound, 1e-8);
  }
}

// Two cubes that share a face, as parts of assemblies do, are one block to look at.
TEST(Stress, PartsThatShareAFaceLookLikeOne) {
  std::mt19937_64 random(6);
  for (int k = 0; k < 20; ++k) {
    const Eigen::AngleAxisd turn(0.3 * k, random_direction(random));
    FacetMesh two, one;
    add_box(two, {0, 0, 0}, {1, 1, 1});
    add_box(two, {1, 0, 0}, {2, 1, 1});
    add_box(one, {0, 0, 0}, {2, 1, 1});
    for (FacetMesh* mesh : {&two, &one})
      for (Vec3& p : mesh->positions) p = turn * p;
    const Vec3 d = random_direction(random);
    EXPECT_NEAR(seen_area_along(two, d), seen_area_along(one, d), 1e-12);
  }
}

// 5,184 facets, nearly all of which touch others face to face, edge to edge or corner to corner.
FacetMesh block_of_boxes() {
  FacetMesh mesh;
  for (int x = 0; x < 12; ++x)
    for (int y = 0; y < 12; ++y)
      for (int z = 0; z < 3; ++z) add_box(mesh, Vec3(x, y, z), Vec3(x + 1, y + 1, z + 1));
  return mesh;
}

// Of the same block in one piece, lit and seen, across the receiver's view.
double seen_of_block(const Vec3& di, const Vec3& dr) {
  const Vec3 faces(12 * 3, 12 * 3, 12 * 12);
  double area = 0.0;
  for (int k = 0; k < 3; ++k)
    if (di[k] * dr[k] > 0.0) area += faces[k] * std::abs(dr[k]);
  return area;
}

// Along axes, edges and diagonals silhouettes fall on edges behind them; turned, the boxes overlap or part by rounding.
TEST(Stress, ThousandsOfTouchingFacetsLookLikeOneBlockWhateverTheView) {
  const double grazing = 89.9999 * std::numbers::pi / 180.0;
  const std::vector<Vec3> views{
      {0, 0, 1}, {1, 1, 0}, {1, 1, 1}, {3, 1, 2}, {std::sin(grazing), 0.3, std::cos(grazing)}};
  for (const double angle : {0.0, 0.7}) {
    const Eigen::AngleAxisd turn(angle, Vec3(2, -1, 3).normalized());
    FacetMesh mesh = block_of_boxes();
    for (Vec3& p : mesh.positions) p = turn * p;
    const Target target = target_of(mesh, lambert(1.0));
    const Visibility visibility(target.mesh);
    for (const Vec3& to_receiver : views)
      for (const Vec3& to_transmitter : {to_receiver, views[3]}) {
        const Vec3 di = to_transmitter.normalized(), dr = to_receiver.normalized();
        const CrossSection section = cross_section(target, visibility, turn * di, turn * dr);
        EXPECT_NEAR(section.seen_area, seen_of_block(di, dr), 1e-10 * seen_of_block(di, dr))
            << angle << ", from " << di.transpose() << ", to " << dr.transpose();
      }
  }
}

// Scale, place, winding and numbering change nothing, even where thousands touch.
TEST(Stress, LawsHoldForThousandsOfTouchingFacets) {
  const FacetMesh block = block_of_boxes();
  const Vec3 di = Vec3(3, 1, 2).normalized(), dr = Vec3(1, 4, 2).normalized();
  const auto sigma_of = [&](const FacetMesh& mesh) {
    return section_of(target_of(mesh, library("metal-skin-9p")), di, dr).sigma.value;
  };
  const double sigma = sigma_of(block);
  FacetMesh scaled = block, moved = block, mixed = block;
  for (Vec3& p : scaled.positions) p *= 1e-9;
  EXPECT_NEAR(sigma_of(scaled), 1e-18 * sigma, 1e-28 * sigma);
  for (Vec3& p : moved.positions) p += Vec3(1 << 24, -(1 << 23), 1 << 22);
  EXPECT_NEAR(sigma_of(moved), sigma, 1e-10 * sigma);
  EXPECT_NEAR(sigma_of(reversed(block)), sigma, 1e-10 * sigma);
  std::mt19937_64 random(11);
  std::shuffle(mixed.facets.begin(), mixed.facets.end(), random);
  EXPECT_NEAR(sigma_of(mixed), sigma, 1e-10 * sigma);
}

}  // namespace
}  // namespace lrcs
