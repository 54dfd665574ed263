#include "lrcs/edge_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lrcs {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

// About four cells an edge, as square as may be.
void EdgeGrid::lay_out(const std::vector<OutlineEdge>& edges, double rounding) {
  double x1 = -infinity, y1 = -infinity;
  grid_.x0 = grid_.y0 = infinity;
  for (const OutlineEdge& e : edges) {
    grid_.x0 = std::min({grid_.x0, e.at_low.x() - rounding, e.at_high.x() - rounding});
    grid_.y0 = std::min({grid_.y0, e.at_low.y() - rounding, e.at_high.y() - rounding});
    x1 = std::max({x1, e.at_low.x() + rounding, e.at_high.x() + rounding});
    y1 = std::max({y1, e.at_low.y() + rounding, e.at_high.y() + rounding});
  }
  constexpr int most = 2048;
  const double cells = 4.0 * static_cast<double>(edges.size()) + 16.0;
  const double width = edges.empty() ? 1.0 : x1 - grid_.x0, height = edges.empty() ? 1.0 : y1 - grid_.y0;
  const auto share = [&](double a, double b) {
    const double count = b > 0.0 ? std::sqrt(cells * a / b) : most;
    return static_cast<int>(std::clamp(count, 1.0, static_cast<double>(most)));
  };
  grid_.columns = share(width, height);
  grid_.rows = share(height, width);
  grid_.per_x = width > 0.0 ? grid_.columns / width : 0.0;
  grid_.per_y = height > 0.0 ? grid_.rows / height : 0.0;
}

void EdgeGrid::fill(const std::vector<OutlineEdge>& edges, double rounding) {
  lay_out(edges, rounding);
  // Long edges pass many cells: no more of those than pays.
  const std::size_t most = 64 * edges.size() + 65536;
  while (grid_.columns + grid_.rows > 2 && entries_needed(edges, rounding) > most) coarsen();
  const std::size_t cells = grid_.size();
  begins_.assign(cells + 1, 0);
  for (const OutlineEdge& e : edges)
    grid_.visit_line(e.at_low, e.at_high, rounding, [&](std::size_t cell) { ++begins_[cell + 1]; });
  for (std::size_t k = 0; k < cells; ++k) begins_[k + 1] += begins_[k];
  ends_.resize(begins_[cells]);
  each_.resize(edges.size());
  next_.assign(begins_.begin(), begins_.end() - 1);
  near_.assign(cells, -std::numeric_limits<float>::infinity());
  for (std::uint32_t k = 0; k < edges.size(); ++k) {
    const OutlineEdge& e = edges[k];
    each_.put(k, e, k);
    const float near = float_above(std::max(e.at_low.z(), e.at_high.z()) + rounding);
    grid_.visit_line(e.at_low, e.at_high, rounding, [&](std::size_t cell) {
      ends_.put(next_[cell]++, e, k);
      near_[cell] = std::max(near_[cell], near);
    });
  }
  const auto across = static_cast<std::size_t>(grid_.columns) + 1;
  filled_before_.assign(across * (static_cast<std::size_t>(grid_.rows) + 1), 0);
  for (std::size_t row = 0; row < static_cast<std::size_t>(grid_.rows); ++row) {
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
  for (const OutlineEdge& e : edges) grid_.visit_line(e.at_low, e.at_high, rounding, [&](std::size_t) { ++count; });
  return count;
}

void EdgeGrid::coarsen() {
  for (auto [count, per] : {std::pair(&grid_.columns, &grid_.per_x), std::pair(&grid_.rows, &grid_.per_y)}) {
    const int half = (*count + 1) / 2;
    *per *= static_cast<double>(half) / *count;
    *count = half;
  }
}

EdgeGrid::Cells EdgeGrid::cells(double x0, double x1, double y0, double y1) const {
  return {grid_.column_of(x0), grid_.column_of(x1), grid_.row_of(y0), grid_.row_of(y1)};
}

std::size_t EdgeGrid::entries(const Cells& c) const {
  std::size_t count = 0;
  for (int row = c.y0; row <= c.y1; ++row) {
    const Run run_of_row = run(row, c.x0, c.x1);
    count += run_of_row.last - run_of_row.first;
  }
  return count;
}

bool EdgeGrid::any(const Cells& c) const {
  const auto across = static_cast<std::size_t>(grid_.columns) + 1;
  const auto sum = [&](int column, int row) {
    return filled_before_[static_cast<std::size_t>(row) * across + static_cast<std::size_t>(column)];
  };
  return sum(c.x1 + 1, c.y1 + 1) + sum(c.x0, c.y0) != sum(c.x0, c.y1 + 1) + sum(c.x1 + 1, c.y0);
}

bool EdgeGrid::any_before(const Cells& c, double z) const {
  bool any = false;
  for (int row = c.y0; row <= c.y1 && !any; ++row)
    for (int column = c.x0; column <= c.x1; ++column) any = any || near_[grid_.cell(column, row)] >= z;
  return any;
}

}  // namespace lrcs
