#include "lrcs/edge_sieve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "lrcs/facet_sight.h"
#include "tests/lrcs/test_targets.h"

namespace lrcs {
namespace {

struct PairCounts {
  std::size_t matter = 0, let_through = 0, all = 0;  // pairs of a facet and an edge that is none of its own
};

bool boxes_meet(const SeenFacet& facet, const OutlineEdge& edge) {
  const auto [x0, x1] = std::minmax({edge.at_low.x(), edge.at_high.x()});
  const auto [y0, y1] = std::minmax({edge.at_low.y(), edge.at_high.y()});
  return x1 >= facet.left && x0 <= facet.right && y1 >= facet.bottom && y0 <= facet.top &&
         std::max(edge.at_low.z(), edge.at_high.z()) >= facet.far;
}

// FacetSight knows the doubles: what it does not rule out, the sieve must not rule out either.
PairCounts expect_all_that_matters_let_through(const FacetMesh& mesh, const Vec3& toward) {
  const Surface surface(mesh);
  ViewOutline view(surface);
  view.look_along(toward);
  const auto& edges = view.edges();
  EdgeEnds ends;
  ends.resize(edges.size());
  for (std::uint32_t k = 0; k < edges.size(); ++k) ends.put(k, edges[k], k);
  FacetSight sight;
  EdgeSieve sieve;
  PairCounts counts;
  std::vector<std::uint32_t> by_all, by_boxes;
  for (std::uint32_t f = 0; f < surface.occluders.size(); ++f) {
    if (view.counts(f) == 0) continue;
    const auto& ids = surface.occluders.facets[f];
    const SeenFacet facet(view, ids);
    sight.look_at(facet, ids, view.rounding());
    sieve.look_at(facet, view.rounding(), 2.0 * surface.tree.reach());
    by_all.clear();
    by_boxes.clear();
    sieve.sift(ends, 0, edges.size(), by_all);
    sieve.sift_boxes(ends, 0, edges.size(), by_boxes);
    counts.all += edges.size();
    counts.let_through += by_all.size();
    for (std::uint32_t k = 0; k < edges.size(); ++k) {
      if (!boxes_meet(facet, edges[k])) continue;
      const bool own = std::ranges::count(ids, edges[k].low) > 0 && std::ranges::count(ids, edges[k].high) > 0;
      EXPECT_TRUE(std::ranges::binary_search(by_boxes, k)) << "facet " << f << " edge " << k;
      if (own || sight.certainly_passes_by(edges[k])) continue;
      ++counts.matter;
      EXPECT_TRUE(std::ranges::binary_search(by_all, k)) << "facet " << f << " edge " << k;
    }
  }
  return counts;
}

FacetMesh soup(std::mt19937_64& random, int facets, double size, double thickness) {
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  const auto anywhere = [&] { return Vec3(place(random), place(random), place(random)); };
  FacetMesh mesh;
  for (int k = 0; k < facets; ++k) {
    const Vec3 a = anywhere(), along = size * anywhere(), aside = size * thickness * anywhere();
    add_triangle(mesh, a, a + along, a + aside);
  }
  measure_facets(mesh);
  return mesh;
}

TEST(EdgeSieve, RulesOutNothingThatMatters) {
  std::mt19937_64 random(3);
  for (const double size : {2.0, 0.1, 1e-3})
    for (const double thickness : {1.0, 1e-3, 1e-7})
      for (int k = 0; k < 4; ++k)
        expect_all_that_matters_let_through(soup(random, 80, size, thickness), random_direction(random));
}

TEST(EdgeSieve, RulesOutNothingThatMattersAmongCoincidences) {
  std::mt19937_64 random(5);
  std::uniform_int_distribution<int> whole(0, 3);
  for (int k = 0; k < 20; ++k) {
    FacetMesh mesh;
    const auto p = [&] { return Vec3(whole(random), whole(random), whole(random)); };
    for (int facet = 0; facet < 60; ++facet) add_triangle(mesh, p(), p(), p());
    measure_facets(mesh);
    expect_all_that_matters_let_through(mesh, k % 2 == 0 ? Vec3(Vec3::UnitX()) : random_direction(random));
  }
}

TEST(EdgeSieve, RulesOutMostOfWhatDoesNot) {
  std::mt19937_64 random(7);
  const PairCounts counts = expect_all_that_matters_let_through(soup(random, 400, 0.3, 1.0), random_direction(random));
  EXPECT_GT(counts.all, 50 * counts.matter);
  EXPECT_LT(counts.let_through, 3 * counts.matter);
}

}  // namespace
}  // namespace lrcs
