#pragma once
#include <cstddef>
#include <string>

namespace lrcs {

// What a sweep did not have to do, each with its count: `skipped` in manifest.json. None changes a result by more than
// its bound. check: tests/lrcs/skips_test.cpp: with and without, and the counts of known cases.
struct SkipCounts {
  std::size_t convex_facets = 0;          // facets of a convex target: no visibility sought
  std::size_t facets_never_faced = 0;     // of a convex target: in blocks turned away from every direction
  std::size_t facets_without_return = 0;  // whose material returns nothing: they block, no BRDF is evaluated
  std::size_t repeated_directions = 0;    // rows with the directions of an earlier row
  std::size_t mirrored_directions = 0;    // rows that mirror an earlier one in a symmetry plane
  std::string mirror_planes;              // normal to which axes, e.g. "yz"; sought only where the sweep could use them
  std::size_t monostatic_directions = 0;  // rows computed with one visibility pass, and the BRDF from cos theta alone
  std::size_t fixed_gamma_directions = 0;  // other rows computed: what depends on the pair is evaluated once a row
};

}  // namespace lrcs
