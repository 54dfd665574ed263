#include "lrcs/facet_piece.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <utility>
#include <vector>

#include "lrcs/stand_in.h"

namespace lrcs {
namespace {

using Point = Eigen::Vector2d;

// A triangle that covers, as outlines: what a facet sees of a layer before it.
std::vector<LayerEdge> layer(std::mt19937_64& random) {
  std::uniform_real_distribution<double> place(-0.5, 1.5);
  std::array<Point, 3> p;
  for (auto& corner : p) corner = {place(random), place(random)};
  const Point a = p[1] - p[0], b = p[2] - p[0];
  if (a.x() * b.y() - a.y() * b.x() < 0.0) std::swap(p[1], p[2]);
  std::vector<LayerEdge> edges;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto &from = p[k], &to = p[(k + 1) % 3];
    // Counterclockwise: an edge that falls has the inside right of it.
    edges.push_back({from.x(), from.y(), to.x(), to.y(), to.y() < from.y() ? 1 : -1});
  }
  return edges;
}

double apart(const AreaMoments& a, const AreaMoments& b) {
  return std::abs(a.area - b.area) + (a.first - b.first).norm() + (a.second - b.second).norm();
}

AreaMoments seen_of(const FacetPiece& piece, const std::vector<LayerEdge>& edges) {
  std::vector<LayerEdge> within;
  for (const LayerEdge& e : edges) within.push_back(piece.within(e));
  constexpr double rounding = 1e-15;  // of their coordinates
  return piece.on_facet(LayerCount().uncovered(within, rounding));
}

std::array<Point, 3> corners_of(const FacetPiece& piece) {
  const auto corners = piece.corners();
  return {corners.col(0), corners.col(1), corners.col(2)};
}

// Of a triangle: its area, a third of it at each middle of a side, has them.
AreaMoments moments_of(const std::array<Point, 3>& p) {
  const Point a = p[1] - p[0], b = p[2] - p[0], middle = (p[0] + p[1] + p[2]) / 3.0;
  AreaMoments m;
  m.area = 0.5 * std::abs(a.x() * b.y() - a.y() * b.x());
  m.first = m.area * middle;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point of_side = 0.5 * (p[k] + p[(k + 1) % 3]);
    m.second += m.area / 3.0 * of_side * of_side.transpose();
  }
  return m;
}

TEST(FacetPiece, QuartersSeeTogetherWhatItSees) {
  std::mt19937_64 random(5);
  int in_part = 0;
  for (int k = 0; k < 500; ++k) {
    std::vector<LayerEdge> edges = layer(random);
    for (const LayerEdge& e : layer(random)) edges.push_back(e);
    const FacetPiece whole, inverted = whole.quarters()[3], nested = inverted.quarters()[2];
    for (const FacetPiece& piece : {whole, inverted, nested}) {
      const AreaMoments seen = seen_of(piece, edges);
      in_part += seen.area > 0.01 * piece.area() && seen.area < 0.99 * piece.area() ? 1 : 0;
      AreaMoments sum;
      for (const FacetPiece& quarter : piece.quarters()) sum += seen_of(quarter, edges);
      EXPECT_NEAR(apart(sum, seen), 0.0, 1e-13);
    }
  }
  EXPECT_GT(in_part, 300);
}

TEST(FacetPiece, HasItsMomentsWhereNothingCovers) {
  const FacetPiece whole;
  for (const FacetPiece& quarter : whole.quarters())
    for (const FacetPiece& piece : quarter.quarters()) {
      const AreaMoments moments = moments_of(corners_of(piece));
      EXPECT_NEAR(apart(seen_of(piece, {}), moments), 0.0, 1e-15);
      EXPECT_DOUBLE_EQ(moments.area, piece.area());
    }
}

TEST(FacetPiece, GivesPlacesBack) {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> place(-1.0, 2.0);
  for (const FacetPiece& quarter : FacetPiece().quarters())
    for (const FacetPiece& piece : quarter.quarters()) {
      const Point at(place(random), place(random));
      EXPECT_NEAR((piece.on_facet(piece.within(at)) - at).norm(), 0.0, 1e-14);
      const auto corners = corners_of(piece);
      EXPECT_EQ(corners[0], piece.on_facet(Point(0.0, 0.0)));
      EXPECT_EQ(corners[1], piece.on_facet(Point(1.0, 0.0)));
      EXPECT_EQ(corners[2], piece.on_facet(Point(0.0, 1.0)));
    }
}

TEST(StandIn, HasTheMomentsOfTheRegion) {
  std::mt19937_64 random(7);
  int found = 0;
  for (int k = 0; k < 500; ++k) {
    const std::vector<LayerEdge> edges = layer(random);
    for (const FacetPiece& piece : FacetPiece().quarters()) {
      const AreaMoments seen = seen_of(piece, edges);
      const auto corners = stand_in_for(seen, piece);
      if (!corners) continue;
      ++found;
      AreaMoments triangle = moments_of({corners->col(0), corners->col(1), corners->col(2)});
      const double scale = seen.area / triangle.area;
      triangle.first *= scale, triangle.second *= scale, triangle.area = seen.area;
      EXPECT_NEAR(apart(triangle, seen), 0.0, 1e-12 * seen.area + 1e-16);
    }
  }
  EXPECT_GT(found, 500);
}

TEST(StandIn, ForAWholePieceIsThePiece) {
  for (const FacetPiece& piece : FacetPiece().quarters()) {
    const auto corners = corners_of(piece);
    const auto stand_in = stand_in_for(moments_of(corners), piece);
    ASSERT_TRUE(stand_in);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR((stand_in->col(static_cast<Eigen::Index>(k)) - corners[k]).norm(), 0.0, 1e-14);
  }
}

TEST(StandIn, KeepsAreaAndMiddleWhereNoRegionHasTheSecondMoments) {
  const FacetPiece whole;
  for (const double factor : {0.5, 10.0}) {  // spread less than not at all; further than the facet
    AreaMoments region = moments_of(corners_of(whole));
    region.area *= 0.25, region.first *= 0.25, region.second *= 0.25 * factor;
    const auto corners = stand_in_for(region, whole);
    ASSERT_TRUE(corners);
    const AreaMoments triangle = moments_of({corners->col(0), corners->col(1), corners->col(2)});
    EXPECT_NEAR(triangle.area, region.area, 1e-15);
    EXPECT_NEAR((triangle.first - region.first).norm(), 0.0, 1e-15);
  }
}

TEST(StandIn, IsNotMadeForMomentsThatNoRegionHas) {
  const FacetPiece whole;
  const AreaMoments good = moments_of(corners_of(whole));
  EXPECT_TRUE(stand_in_for(good, whole));
  AreaMoments bad = good;
  bad.area = 0.0;
  EXPECT_FALSE(stand_in_for(bad, whole));
  bad = good;
  bad.first *= -1.0;  // its middle lies beside
  EXPECT_FALSE(stand_in_for(bad, whole));
}

}  // namespace
}  // namespace lrcs
