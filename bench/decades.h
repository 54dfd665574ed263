#pragma once
#include <string>
#include <vector>

#include "view/cartesian_frame.h"

namespace lrcs {

// A logarithmic axis from half a decade below the least of the values to half a decade beyond the largest, marks at the
// whole decades. domain: values above 0, at least one.
[[nodiscard]] Axis decades(const std::string& title, const std::vector<double>& values);

// Pale lines at 2, 3 ... 9 of every decade of both axes.
void rule_finely(Canvas& canvas, const CartesianFrame& frame);

}  // namespace lrcs
