#include "bench/decades.h"

#include <algorithm>
#include <cmath>

#include "view/ticks.h"

namespace lrcs {
namespace {

std::string decade_label(int exponent) {
  if (exponent >= -2 && exponent <= 5) return number_label(std::pow(10.0, exponent), 6);
  return "1e" + number_label(exponent, 3);
}

// 2, 3 ... 9 in every decade of the axis.
std::vector<double> between_marks(const Axis& axis) {
  std::vector<double> values;
  for (double decade = std::pow(10.0, std::floor(std::log10(axis.low))); decade < axis.high; decade *= 10.0)
    for (int digit = 2; digit <= 9; ++digit)
      if (digit * decade > axis.low && digit * decade < axis.high) values.push_back(digit * decade);
  return values;
}

}  // namespace

Axis decades(const std::string& title, const std::vector<double>& values) {
  const double clear = std::sqrt(10.0);
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  Axis axis{title, *least / clear, *most * clear, {}, {}, true};
  const int last = static_cast<int>(std::floor(std::log10(axis.high)));
  for (int k = static_cast<int>(std::ceil(std::log10(axis.low))); k <= last; ++k) {
    axis.marks.push_back(std::pow(10.0, k));
    axis.labels.push_back(decade_label(k));
  }
  return axis;
}

void rule_finely(Canvas& canvas, const CartesianFrame& frame) {
  std::vector<std::vector<Point>> lines;
  for (const double x : between_marks(frame.x)) lines.push_back({frame.at(x, frame.y.low), frame.at(x, frame.y.high)});
  for (const double y : between_marks(frame.y)) lines.push_back({frame.at(frame.x.low, y), frame.at(frame.x.high, y)});
  constexpr Colour pale{0.94, 0.94, 0.94};
  canvas.strokes(lines, {pale, 1.0});
}

}  // namespace lrcs
