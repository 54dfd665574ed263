#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

#include "mesh/facet_mesh.h"

namespace lrcs {

// What was counted, and whether that is all: else there are at least so many pairs.
struct SelfIntersections {
  std::size_t pairs = 0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> between_parts;  // of them, by the two parts
  bool complete = true;
};

// Seconds' worth of tests: a pair whose boxes overlap takes a fraction of a microsecond.
constexpr std::size_t most_self_intersection_tests = 10'000'000;

// The number of pairs of facets that have a point in common other than the vertices and the edge that they share.
// Exact. Facets that share an edge count where they lie on each other; with the same three vertices (a sheet and its
// back) they do not count. Facets that touch without sharing vertices (a corner on another facet's edge, two bodies
// that lie face to face) do count.
// Only pairs of facets whose boxes overlap are tested; after `most_tests` of them, and 20 more for every facet (its
// neighbours are tested too), the count stops and is not complete.
// The order of the tests is fixed, so the same mesh gives the same count.
// domain: a welded mesh without facets of area zero (repair.h).
// check: against all pairs, and on bodies put into each other (tests/mesh/self_intersections_test.cpp).
[[nodiscard]] SelfIntersections self_intersections(const FacetMesh& welded,
                                                   std::size_t most_tests = most_self_intersection_tests);

}  // namespace lrcs
