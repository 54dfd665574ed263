#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "base/vec3.h"

namespace lrcs {

// Cells of equal size across a view, in columns and rows. What lies beside the grid counts to the cells at its rim.
struct CellGrid {
  double x0 = 0.0, y0 = 0.0;        // corner of the first cell
  double per_x = 0.0, per_y = 0.0;  // cells a length; 0: all in one
  int columns = 0, rows = 0;

  [[nodiscard]] int column_of(double x) const { return cell_of((x - x0) * per_x, columns); }
  [[nodiscard]] int row_of(double y) const { return cell_of((y - y0) * per_y, rows); }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  [[nodiscard]] std::size_t cell(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
  // Where a row begins and ends, widened by `rounding`.
  [[nodiscard]] double bottom_of(int row, double rounding) const { return y0 + row / per_y - rounding; }
  [[nodiscard]] double top_of(int row, double rounding) const { return y0 + (row + 1) / per_y + rounding; }

  // The cells that a line from one place in the view to another passes through, row by row: visit(cell).
  // `rounding`: error of x and y.
  template <class Visit>
  void visit_line(const Vec3& from, const Vec3& to, double rounding, const Visit& visit) const {
    const bool rises = from.y() <= to.y();
    const Vec3 &a = rises ? from : to, &b = rises ? to : from;
    const int row0 = row_of(a.y() - rounding), row1 = row_of(b.y() + rounding);
    const double left = std::min(a.x(), b.x()) - rounding, right = std::max(a.x(), b.x()) + rounding;
    const double slope = b.y() > a.y() ? (b.x() - a.x()) / (b.y() - a.y()) : 0.0;
    for (int row = row0; row <= row1; ++row) {
      double low = left, high = right;
      if (row1 > row0 && slope != 0.0) {
        // The rounding of x and y is larger than that of what follows.
        const double at_bottom = a.x() + slope * (bottom_of(row, rounding) - a.y());
        const double at_top = a.x() + slope * (top_of(row, rounding) - a.y());
        low = std::max(low, std::min(at_bottom, at_top) - rounding);
        high = std::min(high, std::max(at_bottom, at_top) + rounding);
      }
      const int last = column_of(high);
      for (int column = column_of(low); column <= last; ++column) visit(cell(column, row));
    }
  }

 private:
  static int cell_of(double place, int count) {
    return place <= 0.0 ? 0 : place >= count ? count - 1 : static_cast<int>(place);
  }
};

// The nearest float that is not above, and not below.
[[nodiscard]] inline float float_below(double x) {
  const auto rounded = static_cast<float>(x);
  return rounded <= x ? rounded : std::nextafter(rounded, -std::numeric_limits<float>::infinity());
}
[[nodiscard]] inline float float_above(double x) {
  return -float_below(-x);
}

}  // namespace lrcs
