#include "view/brdf_axes.h"

#include <cmath>

#include "view/ticks.h"

namespace lrcs {
namespace {

void mark(Axis& axis, double step) {
  axis.marks = multiples(axis.low, axis.high, step);
  for (const double value : axis.marks) axis.labels.push_back(tick_label(value, step));
}

// Of 10^foot, ..., 10^top: one way of writing them on one axis.
std::vector<std::string> decade_labels(double foot, double top) {
  constexpr double plain = 3.0;
  const bool is_plain = foot >= -plain && top <= plain;
  std::vector<std::string> labels;
  for (double decade = foot; decade <= top; decade += 1.0)
    labels.push_back(is_plain ? number_label(std::pow(10.0, decade), 4) : "1e" + number_label(decade, 3));
  return labels;
}

// 2, 3, ... 9 times each mark but the last.
std::vector<double> between_decades(const std::vector<double>& marks) {
  std::vector<double> between;
  for (std::size_t i = 0; i + 1 < marks.size(); ++i)
    for (int digit = 2; digit <= 9; ++digit) between.push_back(digit * marks[i]);
  return between;
}

Axis logarithmic_axis(const std::string& title, const Extent& positive) {
  constexpr double most_decades = 6.0;
  const double top = std::ceil(std::log10(positive.high));
  double foot = std::max(std::floor(std::log10(positive.low)), top - most_decades);
  if (foot == top) foot -= 1.0;
  Axis axis{title, std::pow(10.0, foot), std::pow(10.0, top), {}, {}, true};
  for (double decade = foot; decade <= top; decade += 1.0) axis.marks.push_back(std::pow(10.0, decade));
  axis.labels = decade_labels(foot, top);
  axis.minor_marks = between_decades(axis.marks);
  return axis;
}

}  // namespace

Axis scattering_axis(const Extent& angles, const std::string& title) {
  Extent extent = angles.empty() ? Extent{0.0, 0.0} : angles;
  if (extent.low == extent.high) extent = {extent.low - 5.0, extent.high + 5.0};
  const double step = angle_step(extent.high - extent.low, 12);
  // Data that end just short of a mark (89 deg) get an axis that ends on it.
  constexpr double short_of = 0.1;  // [step]
  const double last = step * std::floor(extent.high / step + short_of);
  const double first = step * std::ceil(extent.low / step - short_of);
  Axis axis{title, std::min(extent.low, first), std::max(extent.high, last), {}, {}, false};
  mark(axis, step);
  return axis;
}

Axis linear_axis(const std::string& title, double lowest, double highest, int most) {
  const double low = std::min(lowest, 0.0);
  const double step = nice_step(highest - low, most);
  Axis axis{title, step * std::floor(low / step), step * std::ceil(highest / step), {}, {}, false};
  mark(axis, step);
  return axis;
}

Axis symmetric_axis(const std::string& title, double reach) {
  constexpr int steps = 5;  // a step is then less than the reach
  Axis axis{title, -reach, reach, {}, {}, false};
  mark(axis, nice_step(2.0 * reach, steps));
  return axis;
}

Axis f_r_axis(const Extent& all, const Extent& positive, ValueScale scale) {
  constexpr double ratio_for_logarithm = 50.0;
  const std::string title = "BRDF [1/sr]";
  if (positive.empty()) return linear_axis(title, all.empty() ? 0.0 : all.low, 1.0);
  const bool wide = positive.high > ratio_for_logarithm * positive.low;
  const bool logarithmic = scale == ValueScale::logarithmic || (scale == ValueScale::automatic && wide);
  return logarithmic ? logarithmic_axis(title, positive) : linear_axis(title, all.low, positive.high);
}

std::string incidence_label(double theta_i_deg) {
  return "incidence " + number_label(theta_i_deg, 6) + "°";
}

void draw_broken_line(Canvas& canvas, const CartesianFrame& frame, const std::vector<double>& x,
                      const std::vector<double>& y, const Pen& pen) {
  std::vector<Point> stroke;
  const auto finish = [&] {
    canvas.line(stroke, pen);
    stroke.clear();
  };
  for (std::size_t i = 0; i < y.size(); ++i) {
    const bool drawable = std::isfinite(y[i]) && (y[i] > 0.0 || !frame.y.logarithmic);
    if (drawable) stroke.push_back(frame.at(x[i], y[i]));
    if (!drawable) finish();
  }
  finish();
}

}  // namespace lrcs
