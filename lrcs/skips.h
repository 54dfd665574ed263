#pragma once
#include <cstddef>
#include <string>

namespace lrcs {

// What a sweep did not have to do, each with its count: `skipped` in manifest.json. None changes a result by more than
// its bound. check: tests/lrcs/skips_test.cpp: with and without, and the counts of known cases.
struct SkipCounts {
  std::size_t convex_facets = 0;      // facets of a convex target: no visibility sought
  std::size_t hull_facets = 0;        // on the convex hull of another target: nothing can stand before them; they are
                                      // neither cut by outlines nor start a count of layers (lrcs/hull_facets.h)
  std::size_t free_convex_parts = 0;  // convex parts that nothing else stood before, so that all that faces the viewer
                                      // is seen whole: summed over rows and their viewers (lrcs/free_parts.h)
  std::size_t parts_apart = 0;  // other parts of which the same holds, that have facets on their own hull and not on
                                // the target's: only those facets are seen whole; the same sum
  std::size_t facets_never_faced = 0;  // turned away from every direction. Of a convex target: in whole blocks; of
                                       // another one: of solids, where there are directions enough (lrcs/never_faced.h)
  std::size_t facets_without_return = 0;  // whose material returns nothing: they block, no BRDF is evaluated
  std::size_t repeated_directions = 0;    // rows with the directions of an earlier row
  std::size_t mirrored_directions = 0;    // rows that mirror an earlier one in a symmetry plane
  std::string mirror_planes;              // normal to which axes, e.g. "yz"; sought only where the sweep could use them
  std::size_t monostatic_directions = 0;  // rows computed with one visibility pass, and the BRDF from cos theta alone
  std::size_t fixed_gamma_directions = 0;  // other rows computed: what depends on the pair is evaluated once a row
};

}  // namespace lrcs
