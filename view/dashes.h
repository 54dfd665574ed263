#pragma once
#include <vector>

namespace lrcs {

struct Point;

// Cuts a line into its inked strokes. `dash`: lengths of ink and of gap, in turn, along the line; empty: one stroke.
// domain: an even number of positive lengths, else std::invalid_argument.
// laws: the strokes' lengths sum to the inked share of the line; corners inside a stroke stay.
[[nodiscard]] std::vector<std::vector<Point>> dashes(const std::vector<Point>& line, const std::vector<double>& dash);

}  // namespace lrcs
