#include "lrcs/facet_piece.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <utility>
#include <vector>

namespace lrcs {
namespace {

// A triangle that covers, as outlines: what a facet sees of a layer before it.
std::vector<LayerEdge> layer(std::mt19937_64& random) {
  std::uniform_real_distribution<double> place(-0.5, 1.5);
  std::array<Eigen::Vector2d, 3> p;
  for (auto& corner : p) corner = {place(random), place(random)};
  const Eigen::Vector2d a = p[1] - p[0], b = p[2] - p[0];
  if (a.x() * b.y() - a.y() * b.x() < 0.0) std::swap(p[1], p[2]);
  std::vector<LayerEdge> edges;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto &from = p[k], &to = p[(k + 1) % 3];
    // Counterclockwise: an edge that falls has the inside right of it.
    edges.push_back({from.x(), from.y(), to.x(), to.y(), to.y() < from.y() ? 1 : -1});
  }
  return edges;
}

TEST(FacetPiece, QuartersSeeTogetherWhatTheFacetSees) {
  std::mt19937_64 random(5);
  constexpr double rounding = 1e-15;
  LayerCount count;
  int in_part = 0;
  for (int k = 0; k < 500; ++k) {
    std::vector<LayerEdge> edges = layer(random);
    for (const LayerEdge& e : layer(random)) edges.push_back(e);
    const double whole = count.uncovered_area(edges, rounding, 0, true);
    const Eigen::Vector2d moments = count.moments();
    in_part += whole > 0.01 && whole < 0.49 ? 1 : 0;
    double area = 0.0;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const FacetPiece& quarter : FacetPiece::quarters) {
      std::vector<LayerEdge> within;
      for (const LayerEdge& e : edges) within.push_back(quarter.within(e));
      const double seen = count.uncovered_area(within, rounding, 0, true);
      const double share = FacetPiece::area / 0.5 * seen;
      area += share;
      if (seen > 0.0) sum += share * quarter.on_facet(count.moments() / seen);
    }
    EXPECT_NEAR(area, whole, 1e-13);
    EXPECT_NEAR((sum - moments).norm(), 0.0, 1e-13);
  }
  EXPECT_GT(in_part, 100);
}

TEST(FacetPiece, GivesPlacesBackAndMovesThoseOutsideIn) {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> place(-1.0, 2.0);
  for (const FacetPiece& quarter : FacetPiece::quarters)
    for (int k = 0; k < 100; ++k) {
      const Eigen::Vector2d at(place(random), place(random));
      EXPECT_NEAR((quarter.on_facet(quarter.within(at)) - at).norm(), 0.0, 1e-14);
      const Eigen::Vector2d in = quarter.within(quarter.nearest_within(at)), here = quarter.within(at);
      EXPECT_GE(std::min({in.x(), in.y(), 1.0 - in.x() - in.y()}), -1e-14);
      const bool is_inside = std::min({here.x(), here.y(), 1.0 - here.x() - here.y()}) >= 0.0;
      EXPECT_TRUE(!is_inside || (in - here).norm() < 1e-14);
    }
}

}  // namespace
}  // namespace lrcs
