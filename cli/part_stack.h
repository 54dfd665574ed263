#pragma once
#include <cstddef>
#include <functional>

#include "cli/past_run.h"
#include "view/stacked_plot.h"
#include "view/viewed_sweep.h"

namespace lrcs {

// What the parts of a target return along a cut of its sweep: computed once more, exactly, row by row.
// value: the seven parts with the largest sums over the cut, the strongest first; the rest are others.
// law: the stack's top is sigma of the row, to 1e-12 of it.
// error: std::runtime_error where it is not, or where it is not what the sweep found before (of exact sweeps).
[[nodiscard]] LayerStack part_stack(const PastRun& run, const ViewedCut& cut, std::size_t threads,
                                    const std::function<void(std::size_t done)>& progress);

}  // namespace lrcs
