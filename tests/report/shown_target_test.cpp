#include "report/shown_target.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "report/shown_returns.h"

namespace lrcs {
namespace {

// Two spheres of radius 1 (in units of 2 m), 4 n (n - 1) facets each, apart along x.
FacetMesh two_balls(std::uint32_t n) {
  FacetMesh mesh;
  mesh.metres_per_unit = 2.0;
  mesh.part.names = {"near", "far"};
  for (std::uint32_t part = 0; part < 2; ++part) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::uint32_t ring = 0; ring <= n; ++ring)
      for (std::uint32_t sector = 0; sector < 2 * n; ++sector) {
        const double t = std::numbers::pi * ring / n, p = std::numbers::pi * sector / n;
        mesh.positions.emplace_back(5.0 * part + std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), -std::cos(t));
      }
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      mesh.facets.push_back({first + a, first + b, first + c});
      mesh.part.of.push_back(part);
      mesh.source_facet.push_back(static_cast<std::uint32_t>(mesh.facets.size() - 1));
    };
    for (std::uint32_t ring = 0; ring < n; ++ring)
      for (std::uint32_t sector = 0; sector < 2 * n; ++sector) {
        const std::uint32_t next = (sector + 1) % (2 * n), low = 2 * n * ring, high = low + 2 * n;
        if (ring > 0) add(low + sector, low + next, high + next);
        if (ring + 1 < n) add(low + sector, high + next, high + sector);
      }
  }
  measure_facets(mesh);
  return mesh;
}

Vec3 middle_of(const ShownTarget& shown, std::size_t k) {
  Vec3 sum = Vec3::Zero();
  for (const std::uint32_t v : shown.triangles[k])
    sum += Vec3(shown.positions[v][0], shown.positions[v][1], shown.positions[v][2]);
  return sum / 3.0;
}

TEST(ShownTarget, IsTheTargetInMetresWhereThatIsSmall) {
  const FacetMesh mesh = two_balls(6);
  const ShownTarget shown = shown_target(mesh, mesh.size());
  ASSERT_EQ(shown.size(), mesh.size());
  EXPECT_EQ(shown.triangles, mesh.facets);
  EXPECT_EQ(shown.area, mesh.areas);
  EXPECT_FLOAT_EQ(shown.positions[3][2], static_cast<float>(2.0 * mesh.positions[3].z()));
}

TEST(ShownTarget, KeepsPartsAreasAndPlacesWithFewerFacets) {
  const FacetMesh mesh = two_balls(40);
  const ShownTarget shown = shown_target(mesh, 1000);
  EXPECT_LE(shown.size(), 1100U);
  EXPECT_GT(shown.size(), 800U);
  EXPECT_NEAR(std::accumulate(shown.area.begin(), shown.area.end(), 0.0),
              std::accumulate(mesh.areas.begin(), mesh.areas.end(), 0.0), 1e-9);
  for (std::size_t k = 0; k < mesh.size(); ++k) {
    EXPECT_EQ(shown.part[shown.shown_of[k]], mesh.part.of[k]);
    const Vec3 middle = 2.0 / 3.0 * (mesh.corners(k)[0] + mesh.corners(k)[1] + mesh.corners(k)[2]);
    EXPECT_LT((middle_of(shown, shown.shown_of[k]) - middle).norm(), 0.6);  // spheres of radius 2 m
  }
  for (std::uint32_t k = 0; k < shown.size(); ++k) {
    EXPECT_GT(shown.area[shown.value_of[k]], 0.0);
    EXPECT_EQ(shown.part[shown.value_of[k]], shown.part[k]);
    EXPECT_TRUE(shown.area[k] == 0.0 || shown.value_of[k] == k);
  }
}

TEST(ShownReturns, AreTheNearestQuarterDecibel) {
  const FacetMesh mesh = two_balls(4);
  const ShownTarget shown = shown_target(mesh, mesh.size());
  ShownReturns returns(shown, {0, 2});
  EXPECT_TRUE(returns.wants(2));
  EXPECT_FALSE(returns.wants(1));
  std::vector<double> sigma(mesh.size(), 0.0), seen(mesh.size(), 0.0);
  sigma[0] = mesh.areas[0] * 3.0, seen[0] = 1.0;
  sigma[1] = mesh.areas[1] * 3.0 * std::pow(10.0, -1.03), seen[1] = 0.5;
  sigma[2] = mesh.areas[2] * 1e-12, seen[2] = 1e-3;
  returns.take(0, sigma, seen, mesh.areas);
  sigma[1] = 0.0, seen[1] = 1.0;
  returns.take(2, sigma, seen, mesh.areas);
  sigma[0] = mesh.areas[0] * 6.0;
  returns.take(1, sigma, seen, mesh.areas);  // not shown, but the brightest of all
  EXPECT_NEAR(returns.brightest(), 6.0, 1e-6);
  const auto levels = returns.levels(), parts = returns.seen();
  ASSERT_EQ(levels.size(), 2 * mesh.size());
  const auto at = [](const std::vector<std::uint8_t>& values, std::size_t facet) {
    return std::pair<int, int>(values[facet],
                               static_cast<std::uint8_t>(values[facet] + values[values.size() / 2 + facet]));
  };
  EXPECT_EQ(at(levels, 0), std::pair(255 - 12, 255 - 12));  // -3.01 dB: 12.04 steps down
  EXPECT_EQ(at(levels, 1), std::pair(255 - 53, 1));         // -13.31 dB: 53.2 steps down; seen, but nothing comes back
  EXPECT_EQ(at(levels, 2), std::pair(1, 1));
  EXPECT_EQ(at(levels, 3), std::pair(0, 0));
  EXPECT_EQ(at(parts, 1), std::pair(128, 255));
  EXPECT_EQ(at(parts, 2), std::pair(1, 1));  // a thousandth is seen
}

}  // namespace
}  // namespace lrcs
