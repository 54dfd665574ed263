#pragma once
#include <string>
#include <vector>

#include "view/cartesian_frame.h"

namespace lrcs {

// What adds up to the LRCS along a cut, layer by layer.
struct StackLayer {
  std::string label;
  std::vector<double> sigma_m2;
};

// shape: one entry an angle everywhere. domain: two angles or more, in rising order; seven layers, and `others`; finite
// numbers, sigma >= 0. Else std::invalid_argument.
struct LayerStack {
  std::vector<double> angle_deg;
  std::vector<StackLayer> layers;  // from the bottom up
  std::vector<double> others_m2;   // the topmost layer; empty: none
};

// The height of the stack's top at each angle: sums that carry their rounding errors along [m^2].
[[nodiscard]] std::vector<double> stack_top(const LayerStack& stack);

struct StackText {
  std::string title;
  std::string note;
  std::string angle_axis;  // with its unit
};

// Draws the layers one upon the other against the angle, linear in m^2, with their labels in a legend: long ones lose
// their beginning. A line runs along the top.
// check: tests/view/stacked_plot_test.cpp.
CartesianFrame draw_stacked_plot(Canvas& canvas, const LayerStack& stack, const StackText& text);

}  // namespace lrcs
