#include "lrcs/layer_count.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "base/vec3.h"

namespace lrcs {
namespace {

using Point = Eigen::Vector2d;
using Polygon = std::vector<Point>;

// The outline of a counter-clockwise polygon: a side that runs down is its left one.
void add_outline(std::vector<LayerEdge>& edges, const Polygon& p) {
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Point &a = p[k], &b = p[(k + 1) % p.size()];
    edges.push_back({a.x(), a.y(), b.x(), b.y(), a.y() > b.y() ? 1 : -1});
  }
}

double uncovered(const std::vector<Polygon>& layers) {
  std::vector<LayerEdge> edges;
  for (const auto& layer : layers) add_outline(edges, layer);
  return LayerCount().uncovered_area(edges, 0x1p-50);
}

Polygon rectangle(double u0, double v0, double u1, double v1) {
  return {{u0, v0}, {u1, v0}, {u1, v1}, {u0, v1}};
}

TEST(LayerCount, OfNothingLeavesTheWholeFacet) {
  EXPECT_DOUBLE_EQ(uncovered({}), 0.5);
}

TEST(LayerCount, OfAFullCoverLeavesNothing) {
  EXPECT_EQ(uncovered({rectangle(-1, -1, 2, 2)}), 0.0);
  EXPECT_EQ(uncovered({{{0, 0}, {1, 0}, {0, 1}}}), 0.0);
}

TEST(LayerCount, SubtractsWhatLiesInside) {
  EXPECT_NEAR(uncovered({rectangle(0.1, 0.2, 0.3, 0.5)}), 0.5 - 0.06, 1e-15);
  EXPECT_NEAR(uncovered({rectangle(-5, 0, 0.5, 7)}), 0.125, 1e-15);
}

TEST(LayerCount, TellsTheMomentsOfWhatIsLeft) {
  std::vector<LayerEdge> edges;
  add_outline(edges, rectangle(0.1, 0.2, 0.3, 0.5));
  const AreaMoments left = LayerCount().uncovered(edges, 0x1p-50);
  EXPECT_NEAR(left.area, 0.5 - 0.06, 1e-15);
  EXPECT_NEAR(left.first.x(), 1.0 / 6.0 - 0.06 * 0.2, 1e-15);
  EXPECT_NEAR(left.first.y(), 1.0 / 6.0 - 0.06 * 0.35, 1e-15);
  EXPECT_NEAR(left.second(0, 0), 1.0 / 12.0 - 0.06 * (0.2 * 0.2 + 0.2 * 0.2 / 12.0), 1e-15);
  EXPECT_NEAR(left.second(1, 1), 1.0 / 12.0 - 0.06 * (0.35 * 0.35 + 0.3 * 0.3 / 12.0), 1e-15);
  EXPECT_NEAR(left.second(0, 1), 1.0 / 24.0 - 0.06 * 0.2 * 0.35, 1e-15);
  EXPECT_EQ(left.second(0, 1), left.second(1, 0));
}

TEST(LayerCount, TellsTheMomentsBetweenCrossingSides) {
  // Left of the rising diagonal, and right of the falling one, of the square from (0.1, 0.1) to (0.5, 0.5).
  std::vector<LayerEdge> edges;
  add_outline(edges, {{-1.0, 0.1}, {0.1, 0.1}, {0.5, 0.5}, {-1.0, 0.5}});
  add_outline(edges, {{0.5, 0.1}, {2.0, 0.1}, {2.0, 0.5}, {0.1, 0.5}});
  add_outline(edges, rectangle(-1.0, -1.0, 2.0, 0.1));
  add_outline(edges, rectangle(-1.0, 0.5, 2.0, 2.0));
  const AreaMoments left = LayerCount().uncovered(edges, 0x1p-50);
  // The triangle (0.1, 0.1), (0.5, 0.1), (0.3, 0.3): its middle at (0.3, 1/6).
  const double area = 0.04;
  EXPECT_NEAR(left.area, area, 1e-15);
  EXPECT_NEAR(left.first.x(), area * 0.3, 1e-15);
  EXPECT_NEAR(left.first.y(), area / 6.0, 1e-15);
  EXPECT_NEAR(left.second(0, 0), area * (0.3 * 0.3 + 0.4 * 0.4 / 24.0), 1e-15);
  EXPECT_NEAR(left.second(1, 1), area * (1.0 / 36.0 + 0.2 * 0.2 / 18.0), 1e-15);
  EXPECT_NEAR(left.second(0, 1), area * 0.3 / 6.0, 1e-15);
}

TEST(LayerCount, TakesOverlappingLayersOnce) {
  EXPECT_NEAR(uncovered({rectangle(0.1, 0.1, 0.3, 0.4), rectangle(0.2, 0.2, 0.4, 0.3)}), 0.5 - 0.06 - 0.01, 1e-15);
}

TEST(LayerCount, FollowsCrossingSides) {
  // Two slanted bars of width 0.1 along u that cross at (0.35, 0.35): each 0.04 less their common lozenge.
  const Polygon rising{{0.1, 0.15}, {0.2, 0.15}, {0.6, 0.55}, {0.5, 0.55}};
  const Polygon falling{{0.5, 0.15}, {0.6, 0.15}, {0.2, 0.55}, {0.1, 0.55}};
  const double lozenge = 0.5 * 0.1 * 0.1;
  // The part of `rising` beyond u + v = 1 does not count: its sides are there at v = 0.475 and 0.525.
  const double beyond = 0.5 * 0.1 * 0.05 + 0.1 * 0.025;
  EXPECT_NEAR(uncovered({rising, falling}), 0.5 - 0.08 + lozenge + beyond, 1e-12);
}

TEST(LayerCount, IsTheSameForLayersCutIntoPieces) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> at(-0.3, 1.2);
  for (int round = 0; round < 200; ++round) {
    std::vector<Polygon> whole, pieces;
    for (int k = 0; k < 8; ++k) {
      Point a(at(random), at(random)), b(at(random), at(random)), c(at(random), at(random));
      const Point ab = b - a, ac = c - a;
      if (ab.x() * ac.y() - ab.y() * ac.x() < 0.0) std::swap(b, c);
      const Point middle = (a + b + c) / 3.0;
      whole.push_back({a, b, c});
      pieces.insert(pieces.end(), {{a, b, middle}, {b, c, middle}, {c, a, middle}});
    }
    EXPECT_NEAR(uncovered(whole), uncovered(pieces), 1e-14);
  }
}

TEST(LayerCount, AgreesWithPointsThrownAtIt) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> at(-0.2, 1.0), unit(0.0, 1.0);
  for (int round = 0; round < 20; ++round) {
    std::vector<Polygon> layers;
    for (int k = 0; k < 5; ++k) {
      Point a(at(random), at(random)), b(at(random), at(random)), c(at(random), at(random));
      const Point ab = b - a, ac = c - a;
      if (ab.x() * ac.y() - ab.y() * ac.x() < 0.0) std::swap(b, c);
      layers.push_back({a, b, c});
    }
    constexpr int points = 40000;
    int free = 0;
    for (int k = 0; k < points; ++k) {
      Point x(unit(random), unit(random));
      if (x.sum() > 1.0) x = Point(1, 1) - x;
      bool covered = false;
      for (const auto& p : layers) {
        bool inside = true;
        for (std::size_t e = 0; e < 3; ++e) {
          const Point side = p[(e + 1) % 3] - p[e], to = x - p[e];
          inside = inside && side.x() * to.y() - side.y() * to.x() >= 0.0;
        }
        covered = covered || inside;
      }
      free += covered ? 0 : 1;
    }
    // Five standard deviations: 20 rounds fail by chance once in 10^5 runs.
    EXPECT_NEAR(2.0 * uncovered(layers), static_cast<double>(free) / points, 5.0 * 0.5 / std::sqrt(points));
  }
}

}  // namespace
}  // namespace lrcs
