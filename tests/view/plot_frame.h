#pragma once
#include "png_pixels.h"

namespace lrcs {

// The middles of the horizontal (or upright) ink lines that are at least so long, in rising order [pixel].
inline std::vector<double> ink_lines(const PngPixels& pixels, bool horizontal, int least) {
  const int lines = pixels.size[horizontal ? 1 : 0];
  const int along = pixels.size[horizontal ? 0 : 1];
  std::vector<double> found;
  int first = -1;
  for (int line = 0; line <= lines; ++line) {
    int length = 0;
    for (int k = 0; line < lines && k < along; ++k)
      length += (horizontal ? pixels.is(ink, k, line) : pixels.is(ink, line, k)) ? 1 : 0;
    if (length >= least && first < 0) first = line;
    if (length < least && first >= 0) {
      found.push_back(0.5 * (first + line));
      first = -1;
    }
  }
  return found;
}

// A ruled rectangle of a plot as found in its picture, and what its axes span.
struct PlotFrame {
  double left, right, bottom, top;  // [pixel]
  double x_low, x_high, y_low, y_high;

  [[nodiscard]] double column(double x) const { return std::lerp(left, right, (x - x_low) / (x_high - x_low)); }
  [[nodiscard]] double row(double y) const { return std::lerp(bottom, top, (y - y_low) / (y_high - y_low)); }

  [[nodiscard]] bool is_at(const PngPixels& pixels, const Colour& colour, double x, double y) const {
    return pixels.is(colour, static_cast<int>(column(x)), static_cast<int>(row(y)));
  }
};

// The colour's pixels within `reach` of a place.
inline Found find_near(const PngPixels& pixels, const Colour& colour, double column, double row, double reach) {
  Found found;
  found.column = found.row = 0.0;
  for (int y = static_cast<int>(row - reach); y <= static_cast<int>(row + reach); ++y)
    for (int x = static_cast<int>(column - reach); x <= static_cast<int>(column + reach); ++x) {
      if (!pixels.is(colour, x, y)) continue;
      ++found.count;
      found.column += x + 0.5;
      found.row += y + 0.5;
    }
  if (found.count > 0) {
    found.column /= found.count;
    found.row /= found.count;
  }
  return found;
}

}  // namespace lrcs
