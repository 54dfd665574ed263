#include "view/sweep_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "view/cartesian_frame.h"
#include "view/cut_drawing.h"
#include "view/plot_file.h"
#include "view/ticks.h"

namespace lrcs {
namespace {

double largest_angle(const std::vector<Curve>& curves) {
  double largest = -std::numeric_limits<double>::infinity();
  for (const Curve& curve : curves) {
    for (const double angle : curve.angle_deg) largest = std::max(largest, angle);
  }
  return largest;
}

// Angles that got a turn added are shown as the user knows them: 370 deg as 10.
double as_given(double angle_deg, double largest_given, double first_deg) {
  const bool turned = angle_deg >= 360.0 && angle_deg > largest_given && first_deg > 0.0;
  return turned ? angle_deg - 360.0 : angle_deg;
}

// width: of the plot [pixel].
Axis angle_axis(const std::vector<Curve>& curves, const CutDrawing& drawing, const PlotText& text, double width) {
  constexpr double room_about_one_angle = 5.0;  // [deg]
  constexpr double most_marks = 12.0, room_a_mark = 130.0;
  Axis axis{text.angle_axis,
            std::numeric_limits<double>::infinity(),
            -std::numeric_limits<double>::infinity(),
            {},
            {},
            false};
  for (const auto& cut : drawing.cuts) {
    for (const CutPoint& point : cut) {
      axis.low = std::min(axis.low, point.angle_deg);
      axis.high = std::max(axis.high, point.angle_deg);
    }
  }
  if (axis.low > axis.high) axis.low = axis.high = 0.0;
  if (axis.low == axis.high) {
    axis.low -= room_about_one_angle;
    axis.high += room_about_one_angle;
  }
  const double marks = std::clamp(width / room_a_mark, 2.0, most_marks);
  const double span = axis.high - axis.low;
  const bool is_angle = text.angle != CutAngle::other;  // else a number of rows
  const double step =
      is_angle ? angle_step(span, static_cast<int>(marks)) : std::max(1.0, nice_step(span, static_cast<int>(marks)));
  axis.marks = multiples(axis.low, axis.high, step);
  for (const double mark : axis.marks) {
    axis.labels.push_back(tick_label(is_angle ? as_given(mark, largest_angle(curves), axis.low) : mark, step));
  }
  return axis;
}

// height: of the plot [pixel]. Where it has no room for a mark a step, steps are larger, and the range whole ones.
Axis decibel_axis(const DecibelRange& range, double height) {
  constexpr double room_a_mark = 90.0;
  const int most_marks = std::max(1, static_cast<int>(height / room_a_mark));
  const double step = std::max(range.step, nice_step(range.high - range.low, most_marks));
  const bool is_wider = step > range.step;
  const double low = is_wider && !range.floor_used ? step * std::floor(range.low / step) : range.low;
  const double high = is_wider ? step * std::ceil(range.high / step) : range.high;
  Axis axis{"LRCS [dBsm]", low, high, multiples(low, high, step), {}, false};
  for (const double mark : axis.marks) axis.labels.push_back(tick_label(mark, step));
  return axis;
}

// The dBsm axis spans no less [dB]. Where bounds are told of, it may be less, for them to show.
double least_span(const std::vector<Curve>& curves) {
  constexpr double plain = 10.0, least = 2.0, told = 0.02;  // [dB]
  constexpr double of_the_band = 40.0;
  double widest = 0.0;
  for (const Curve& curve : curves)
    for (std::size_t i = 0; i < std::min(curve.bound_m2.size(), curve.sigma_m2.size()); ++i)
      if (const double sigma = curve.sigma_m2[i], bound = curve.bound_m2[i]; bound < sigma)
        widest = std::max(widest, 10.0 * std::log10((sigma + bound) / (sigma - bound)));
  return widest < told ? plain : std::clamp(of_the_band * widest, least, plain);
}

}  // namespace

CartesianFrame draw_sweep_plot(Canvas& canvas, const std::vector<Curve>& curves, const PlotText& text) {
  const CutDrawing drawing = cut_drawing(curves, text, least_span(curves), 0.7 * canvas.height());
  const double top = draw_header(canvas, drawing.header);
  CartesianFrame frame = draw_cartesian_frame(canvas, top, angle_axis(curves, drawing, text, canvas.width()),
                                              decibel_axis(drawing.range, canvas.height()));
  const auto map = [&](const CutPoint& point) { return frame.at(point.angle_deg, point.dbsm); };
  draw_bands(canvas, drawing, map, true);
  draw_floor_ticks(canvas, drawing, map);
  draw_curves(canvas, drawing, map, true);
  return frame;
}

void draw_sweep_plot(const std::filesystem::path& file, const std::vector<Curve>& curves, const PlotText& text) {
  Canvas canvas = plot_canvas(file, 1600, 1000);
  draw_sweep_plot(canvas, curves, text);
  write_plot(file, canvas);
}

}  // namespace lrcs
