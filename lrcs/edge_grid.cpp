#include "lrcs/edge_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lrcs {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

int cell_of(double place, double per, int count) {
  const double cell = place * per;
  return cell <= 0.0 ? 0 : cell >= count ? count - 1 : static_cast<int>(cell);
}

constexpr float float_infinity = std::numeric_limits<float>::infinity();

float below(double x) {
  const auto rounded = static_cast<float>(x);
  return rounded <= x ? rounded : std::nextafter(rounded, -float_infinity);
}
float above(double x) {
  const auto rounded = static_cast<float>(x);
  return rounded >= x ? rounded : std::nextafter(rounded, float_infinity);
}

}  // namespace

int EdgeGrid::column_of(double x) const {
  return cell_of(x - x0_, per_x_, columns_);
}
int EdgeGrid::row_of(double y) const {
  return cell_of(y - y0_, per_y_, rows_);
}

// About four cells an edge, as square as may be.
void EdgeGrid::lay_out(const std::vector<OutlineEdge>& edges, double rounding) {
  double x1 = -infinity, y1 = -infinity;
  x0_ = y0_ = infinity;
  for (const OutlineEdge& e : edges) {
    x0_ = std::min({x0_, e.at_low.x() - rounding, e.at_high.x() - rounding});
    y0_ = std::min({y0_, e.at_low.y() - rounding, e.at_high.y() - rounding});
    x1 = std::max({x1, e.at_low.x() + rounding, e.at_high.x() + rounding});
    y1 = std::max({y1, e.at_low.y() + rounding, e.at_high.y() + rounding});
  }
  constexpr int most = 2048;
  const double cells = 4.0 * static_cast<double>(edges.size()) + 16.0;
  const double width = edges.empty() ? 1.0 : x1 - x0_, height = edges.empty() ? 1.0 : y1 - y0_;
  const auto share = [&](double a, double b) {
    const double count = b > 0.0 ? std::sqrt(cells * a / b) : most;
    return static_cast<int>(std::clamp(count, 1.0, static_cast<double>(most)));
  };
  columns_ = share(width, height);
  rows_ = share(height, width);
  per_x_ = width > 0.0 ? columns_ / width : 0.0;
  per_y_ = height > 0.0 ? rows_ / height : 0.0;
}

// The cells that an edge passes through, row by row.
template <class Visit>
void EdgeGrid::visit_cells(const OutlineEdge& edge, double rounding, const Visit& visit) const {
  const bool rises = edge.at_low.y() <= edge.at_high.y();
  const Vec3 &a = rises ? edge.at_low : edge.at_high, &b = rises ? edge.at_high : edge.at_low;
  const int row0 = row_of(a.y() - rounding), row1 = row_of(b.y() + rounding);
  const double x0 = std::min(a.x(), b.x()) - rounding, x1 = std::max(a.x(), b.x()) + rounding;
  const double slope = b.y() > a.y() ? (b.x() - a.x()) / (b.y() - a.y()) : 0.0;
  for (int row = row0; row <= row1; ++row) {
    double from = x0, to = x1;
    if (row1 > row0 && slope != 0.0) {
      // The rounding of x and y is larger than that of what follows.
      const double low = y0_ + row / per_y_ - rounding, high = y0_ + (row + 1) / per_y_ + rounding;
      const double at_low = a.x() + slope * (low - a.y()), at_high = a.x() + slope * (high - a.y());
      from = std::max(from, std::min(at_low, at_high) - rounding);
      to = std::min(to, std::max(at_low, at_high) + rounding);
    }
    const int column0 = column_of(from), column1 = column_of(to);
    for (int column = column0; column <= column1; ++column)
      visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column));
  }
}

void EdgeGrid::fill(const std::vector<OutlineEdge>& edges, double rounding) {
  lay_out(edges, rounding);
  // Long edges pass many cells: no more of those than pays.
  const std::size_t most = 64 * edges.size() + 65536;
  while (columns_ + rows_ > 2 && entries_needed(edges, rounding) > most) coarsen();
  const std::size_t cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  begins_.assign(cells + 1, 0);
  for (const OutlineEdge& e : edges) visit_cells(e, rounding, [&](std::size_t cell) { ++begins_[cell + 1]; });
  for (std::size_t k = 0; k < cells; ++k) begins_[k + 1] += begins_[k];
  edges_.resize(begins_[cells]);
  next_.assign(begins_.begin(), begins_.end() - 1);
  all_.clear();
  for (std::uint32_t k = 0; k < edges.size(); ++k) {
    const OutlineEdge& e = edges[k];
    const auto [x0, x1] = std::minmax(e.at_low.x(), e.at_high.x());
    const auto [y0, y1] = std::minmax(e.at_low.y(), e.at_high.y());
    const double near = std::max(e.at_low.z(), e.at_high.z());
    const Entry entry{below(x0 - rounding), above(x1 + rounding),   below(y0 - rounding),
                      above(y1 + rounding), above(near + rounding), k};
    all_.push_back(entry);
    visit_cells(e, rounding, [&](std::size_t cell) { edges_[next_[cell]++] = entry; });
  }
  const auto across = static_cast<std::size_t>(columns_) + 1;
  filled_before_.assign(across * (static_cast<std::size_t>(rows_) + 1), 0);
  for (std::size_t row = 0; row < static_cast<std::size_t>(rows_); ++row) {
    std::uint32_t in_row = 0;
    for (std::size_t column = 0; column + 1 < across; ++column) {
      const std::size_t cell = row * (across - 1) + column;
      in_row += begins_[cell + 1] > begins_[cell] ? 1 : 0;
      filled_before_[(row + 1) * across + column + 1] = filled_before_[row * across + column + 1] + in_row;
    }
  }
}

std::size_t EdgeGrid::entries_needed(const std::vector<OutlineEdge>& edges, double rounding) const {
  std::size_t count = 0;
  for (const OutlineEdge& e : edges) visit_cells(e, rounding, [&](std::size_t) { ++count; });
  return count;
}

void EdgeGrid::coarsen() {
  for (auto [count, per] : {std::pair(&columns_, &per_x_), std::pair(&rows_, &per_y_)}) {
    const int half = (*count + 1) / 2;
    *per *= static_cast<double>(half) / *count;
    *count = half;
  }
}

EdgeGrid::Cells EdgeGrid::cells(double x0, double x1, double y0, double y1) const {
  return {column_of(x0), column_of(x1), row_of(y0), row_of(y1)};
}

std::size_t EdgeGrid::entries(const Cells& c) const {
  std::size_t count = 0;
  for (int row = c.y0; row <= c.y1; ++row) {
    const std::size_t first = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
    count += begins_[first + static_cast<std::size_t>(c.x1) + 1] - begins_[first + static_cast<std::size_t>(c.x0)];
  }
  return count;
}

bool EdgeGrid::any(const Cells& c) const {
  const auto across = static_cast<std::size_t>(columns_) + 1;
  const auto sum = [&](int column, int row) {
    return filled_before_[static_cast<std::size_t>(row) * across + static_cast<std::size_t>(column)];
  };
  return sum(c.x1 + 1, c.y1 + 1) + sum(c.x0, c.y0) != sum(c.x0, c.y1 + 1) + sum(c.x1 + 1, c.y0);
}

}  // namespace lrcs
