#include "lrcs/seen_parts.h"

#include <gtest/gtest.h>

#include <vector>

namespace lrcs {
namespace {

constexpr double rounding = 1e-15;

// Covers what lies above the line v = at + slope u, as a facet's outlines say it; the line is off by `bend` in v.
std::vector<LayerEdge> covered_above(double at, double slope, double bend) {
  LayerEdge line{0.0, at, 2.0, at + 2.0 * slope, -1, bend, bend, true};
  if (slope < 0.0) line = {2.0, at + 2.0 * slope, 0.0, at, 1, bend, bend, true};
  return {{0.0, at, 0.0, 2.0, 1}, line};
}

// Covers what lies right of the line u = at + slope v; the line is off by `bend` in u.
std::vector<LayerEdge> covered_right(double at, double slope, double bend) {
  return {{at - slope, -1.0, at + slope, 1.0, 1, bend, bend, false}};
}

// Area of the facet below the line v = at + slope u.
double area_below(double at, double slope) {
  const double end = (1.0 - at) / (1.0 + slope);
  return at * end + 0.5 * slope * end * end + 0.5 * (1.0 - end) * (1.0 - end);
}

AreaMoments seen_of(const std::vector<LayerEdge>& edges, const FacetPiece& piece = {}) {
  BentOutlines bent;
  bent.bend(edges, rounding);
  SeenParts parts;
  parts.add({.error = rounding}, edges, bent);
  return parts.seen_within(piece, parts.parts().front());
}

TEST(SeenParts, EndWhereOutlinesAreMovedTo) {
  for (const double slope : {-0.2, 0.0, 0.3})
    for (const double bend : {-0.05, 0.0, 0.07}) {
      EXPECT_NEAR(seen_of(covered_above(0.3, slope, bend)).area, area_below(0.3 + bend, slope), 1e-14);
      EXPECT_NEAR(seen_of(covered_right(0.3, slope, bend)).area, area_below(0.3 + bend, slope), 1e-14);
    }
}

TEST(SeenParts, OfAnOutlineAlongASideOfTheFacetBeginThere) {
  EXPECT_EQ(seen_of(covered_above(0.0, 0.0, -0.03)).area, 0.0);
  for (const double off : {-0.5 * rounding, 0.0, 0.5 * rounding})
    EXPECT_NEAR(seen_of(covered_above(off, 0.0, 0.03)).area, area_below(0.03, 0.0), 2.0 * rounding);
}

TEST(SeenParts, ChangeAlongUAndAlongVByBothTogether) {
  std::vector<LayerEdge> edges = covered_above(0.4, 0.0, 0.03);
  for (const LayerEdge& e : covered_right(0.5, 0.0, 0.02)) edges.push_back(e);
  EXPECT_NEAR(seen_of(edges).area, 0.5 * 0.4 + 0.02 * 0.4 + 0.5 * 0.03, 1e-15);
}

TEST(SeenParts, OfQuartersAddUp) {
  std::vector<LayerEdge> edges = covered_above(0.4, 0.1, 0.03);
  for (const LayerEdge& e : covered_right(0.5, 0.2, 0.02)) edges.push_back(e);
  const AreaMoments whole = seen_of(edges);
  AreaMoments sum;
  for (const FacetPiece& quarter : FacetPiece().quarters()) sum += seen_of(edges, quarter);
  EXPECT_NEAR(sum.area, whole.area, 1e-15);
  EXPECT_NEAR((sum.first - whole.first).norm(), 0.0, 1e-15);
  EXPECT_NEAR((sum.second - whole.second).norm(), 0.0, 1e-15);
}

}  // namespace
}  // namespace lrcs
