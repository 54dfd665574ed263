#pragma once
#include <string>
#include <vector>

#include "view/canvas.h"

namespace lrcs {

// One axis: what it spans, its marks and their labels. shape: one label a mark; low < high.
// logarithmic: equal ratios take equal lengths; low > 0 then.
struct Axis {
  std::string title;
  double low = 0.0;
  double high = 1.0;
  std::vector<double> marks;
  std::vector<std::string> labels;
  bool logarithmic = false;
  std::vector<double> minor_marks = {};  // short ones, without labels
};

// The ruled rectangle of a Cartesian plot.
struct CartesianFrame {
  Box box;  // on the canvas
  Axis x;
  Axis y;

  // Where a value lies on the canvas; beyond the box for a value beyond the axes.
  [[nodiscard]] Point at(double x_value, double y_value) const;
};

// The box below `top` [pixel] that leaves room for the axes' labels and titles.
[[nodiscard]] Box room_for_frame(const Canvas& canvas, double top, const Axis& x, const Axis& y);

// Rules that box, or the given one: grid, marks, labels, titles.
[[nodiscard]] CartesianFrame draw_cartesian_frame(Canvas& canvas, double top, const Axis& x, const Axis& y);
[[nodiscard]] CartesianFrame draw_cartesian_frame(Canvas& canvas, const Box& box, const Axis& x, const Axis& y);

// The frame's outline, over the curves' ends.
void draw_outline(Canvas& canvas, const CartesianFrame& frame);

}  // namespace lrcs
