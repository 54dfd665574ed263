#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "lrcs/aspect.h"
#include "lrcs/cross_section.h"
#include "lrcs/skips.h"

namespace lrcs {

// One row of the result.
struct SweepRow {
  Aspect aspect;
  Estimate sigma;          // [m^2]
  double seen_area = 0.0;  // [m^2]
};

// How the rows of a sweep came about that were computed each by itself or in batches.
struct MethodCounts {
  std::size_t exact = 0;
  std::size_t sampled = 0;
};

// What happens while a sweep runs. Called from several threads, one at a time.
struct SweepWatch {
  std::function<void(std::size_t done)> progress;                                     // may be empty
  std::function<bool(std::size_t row)> wants_facets;                                  // may be empty: none
  std::function<void(std::size_t row, const SweepRow&, const CrossSection&)> facets;  // for the rows wanted
};

// The cross section at every aspect, in the order given. Parallel over aspects.
// What need not be done is skipped (lrcs/skips.h): a convex target's visibility; facets that nothing
// can stand before or that no direction faces; rows with an earlier row's directions,
// or with their images where the target is symmetric: they get its numbers. A row whose facets are wanted is computed
// by itself, exactly. relative: sigma may be off by that part of itself; rows for which it is cheaper are sampled then
// (lrcs/sampled_sections.h), the others exact. None: all exact. What a watcher throws ends the sweep and comes out
// here. law: the same bytes for any number of threads (0: all there are).
[[nodiscard]] std::vector<SweepRow> run_sweep(const Target& target, const std::vector<Aspect>& aspects,
                                              std::size_t threads, const SweepWatch& watch = {},
                                              SkipCounts* skipped = nullptr,
                                              std::optional<double> relative = std::nullopt,
                                              MethodCounts* methods = nullptr);

}  // namespace lrcs
