#include "mesh/polygon_cut.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "mesh/facet_mesh.h"

namespace lrcs {
namespace {

using Facets = std::vector<std::array<std::uint32_t, 3>>;

Facets cut(const std::vector<Vec3>& positions, std::vector<std::uint32_t> corners = {}) {
  if (corners.empty()) {
    corners.resize(positions.size());
    std::iota(corners.begin(), corners.end(), 0U);
  }
  Facets facets;
  cut_polygon(positions, corners, facets);
  return facets;
}

// The sum of the facets' areas, each counted against `normal`: a facet the wrong way round takes off.
double area(const std::vector<Vec3>& positions, const Facets& facets, const Vec3& normal) {
  double sum = 0.0;
  for (const auto& f : facets) sum += 0.5 * facet_cross(positions[f[0]], positions[f[1]], positions[f[2]]).dot(normal);
  return sum;
}

double total_area(const std::vector<Vec3>& positions, const Facets& facets) {
  double sum = 0.0;
  for (const auto& f : facets) sum += 0.5 * facet_cross(positions[f[0]], positions[f[1]], positions[f[2]]).norm();
  return sum;
}

TEST(PolygonCut, CutsAConvexPolygonAsAFan) {
  EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), (Facets{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(cut({{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0.5, 1.5}, {0, 0, 1}}),
            (Facets{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

TEST(PolygonCut, KeepsACornerOf180DegreesInTheFan) {
  EXPECT_EQ(cut({{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}, {0, 1, 0}}), (Facets{{0, 1, 2}, {0, 2, 3}}));
}

TEST(PolygonCut, CoversAnArrowheadOnce) {
  const std::vector<Vec3> dart{{0, 0, 0}, {2, -1, 0}, {0.5, 0, 0}, {2, 1, 0}};
  for (std::uint32_t first = 0; first < 4; ++first) {
    const Facets facets = cut(dart, {first, (first + 1) % 4, (first + 2) % 4, (first + 3) % 4});
    EXPECT_EQ(facets.size(), 2U);
    EXPECT_DOUBLE_EQ(total_area(dart, facets), 0.5);
    EXPECT_DOUBLE_EQ(area(dart, facets, Vec3::UnitZ()), -area(dart, cut(dart, {3, 2, 1, 0}), Vec3::UnitZ()));
  }
}

TEST(PolygonCut, CoversACombOfThousandTeethInAnyPlane) {
  const Vec3 u = Vec3(1, 2, 3).normalized();
  const Vec3 v = Vec3(3, 0, -1).normalized();
  constexpr std::uint32_t teeth = 1000;
  std::vector<Vec3> comb{{0, 0, 0}};
  for (std::uint32_t k = 0; k < teeth; ++k) {
    comb.emplace_back(k * u + v);
    comb.emplace_back((k + 0.5) * u + 0.1 * v);
  }
  comb.emplace_back(teeth * u + v);
  comb.emplace_back(teeth * u);
  const Facets facets = cut(comb);
  EXPECT_EQ(facets.size(), comb.size() - 2);
  EXPECT_NEAR(total_area(comb, facets), teeth * 0.55, 1e-9);
  EXPECT_NEAR(area(comb, facets, v.cross(u)), teeth * 0.55, 1e-9);
}

TEST(PolygonCut, LeavesTheHoleOfABridgedPolygonOpen) {
  // A square with a square hole: out along the bridge 0-4, round the hole, back along it.
  const std::vector<Vec3> positions{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0},
                                    {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}};
  const Facets facets = cut(positions, {0, 1, 2, 3, 0, 4, 5, 6, 7, 4});
  EXPECT_EQ(facets.size(), 8U);
  EXPECT_DOUBLE_EQ(total_area(positions, facets), 8.0);
  EXPECT_DOUBLE_EQ(area(positions, facets, Vec3::UnitZ()), 8.0);
}

TEST(PolygonCut, CoversAStarShapedOutline) {
  std::vector<Vec3> star;
  for (int k = 0; k < 20; ++k) {
    const double angle = std::numbers::pi * k / 10.0;
    star.push_back((k % 2 == 0 ? 1.0 : 0.3) * Vec3(std::cos(angle), std::sin(angle), 0));
  }
  const double truth = 20 * 0.5 * 1.0 * 0.3 * std::sin(std::numbers::pi / 10.0);
  EXPECT_NEAR(total_area(star, cut(star)), truth, 1e-14);
}

TEST(PolygonCut, CutsWhatCrossesItselfOrHasNoInsideAsAFan) {
  EXPECT_EQ(cut({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}), (Facets{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}), (Facets{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(cut({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}), (Facets{{0, 1, 2}, {0, 2, 3}}));
}

}  // namespace
}  // namespace lrcs
