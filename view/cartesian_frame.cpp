#include "view/cartesian_frame.h"

#include <algorithm>
#include <cmath>

#include "view/plot_header.h"

namespace lrcs {
namespace {

constexpr double gap = 14.0;     // between frame and labels [pixel]
constexpr double border = 26.0;  // between titles and the picture's edge [pixel]

constexpr double room_below = 1.2 * axis_font.size + mark_font.size + 2.5 * gap;  // a frame, for labels and title

double share(const Axis& axis, double value) {
  if (axis.logarithmic) return std::log(value / axis.low) / std::log(axis.high / axis.low);
  return (value - axis.low) / (axis.high - axis.low);
}

double widest(const std::vector<std::string>& labels) {
  double width = 0.0;
  for (const std::string& label : labels) width = std::max(width, text_size(label, mark_font).width);
  return width;
}

void draw_x_marks(Canvas& canvas, const CartesianFrame& frame) {
  for (std::size_t i = 0; i < frame.x.marks.size(); ++i) {
    const double x = frame.at(frame.x.marks[i], frame.y.low).x;
    canvas.line({{x, frame.box.low.y}, {x, frame.box.high.y}}, {grid_grey, 2.0});
    canvas.text({x, frame.box.low.y - 1.5 * gap}, frame.x.labels[i],
                {.font = mark_font, .x = AlignX::centre, .y = AlignY::top});
  }
}

void draw_y_marks(Canvas& canvas, const CartesianFrame& frame) {
  constexpr double short_mark = 12.0;  // [pixel]
  for (const double value : frame.y.minor_marks) {
    const double y = frame.at(frame.x.low, value).y;
    canvas.line({{frame.box.low.x, y}, {frame.box.low.x + short_mark, y}}, {ink, 2.0});
  }
  for (std::size_t i = 0; i < frame.y.marks.size(); ++i) {
    const double y = frame.at(frame.x.low, frame.y.marks[i]).y;
    canvas.line({{frame.box.low.x, y}, {frame.box.high.x, y}}, {grid_grey, 2.0});
    canvas.text({frame.box.low.x - gap, y}, frame.y.labels[i],
                {.font = mark_font, .x = AlignX::right, .y = AlignY::middle});
  }
}

void draw_titles(Canvas& canvas, const CartesianFrame& frame) {
  const Box& box = frame.box;
  canvas.text({0.5 * (box.low.x + box.high.x), box.low.y - room_below + 6.0}, frame.x.title,
              {.font = fitting(frame.x.title, axis_font, box.high.x - box.low.x), .x = AlignX::centre});
  canvas.text({border + 0.8 * axis_font.size, 0.5 * (box.low.y + box.high.y)}, frame.y.title,
              {.font = fitting(frame.y.title, axis_font, box.high.y - box.low.y), .x = AlignX::centre, .upward = true});
}

}  // namespace

Point CartesianFrame::at(double x_value, double y_value) const {
  return {std::lerp(box.low.x, box.high.x, share(x, x_value)), std::lerp(box.low.y, box.high.y, share(y, y_value))};
}

Box room_for_frame(const Canvas& canvas, double top, const Axis& x, const Axis& y) {
  const double left = border + 1.2 * axis_font.size + widest(y.labels) + 2.0 * gap;
  const double bottom = border + room_below;
  const double last_label = x.labels.empty() ? 0.0 : 0.5 * text_size(x.labels.back(), mark_font).width;
  return {{left, bottom}, {canvas.width() - border - std::max(gap, last_label), top}};
}

CartesianFrame draw_cartesian_frame(Canvas& canvas, double top, const Axis& x, const Axis& y) {
  return draw_cartesian_frame(canvas, room_for_frame(canvas, top, x, y), x, y);
}

CartesianFrame draw_cartesian_frame(Canvas& canvas, const Box& box, const Axis& x, const Axis& y) {
  CartesianFrame frame{box, x, y};
  draw_x_marks(canvas, frame);
  draw_y_marks(canvas, frame);
  draw_titles(canvas, frame);
  draw_outline(canvas, frame);
  return frame;
}

void draw_outline(Canvas& canvas, const CartesianFrame& frame) {
  canvas.frame(frame.box, {ink, 3.0});
}

}  // namespace lrcs
