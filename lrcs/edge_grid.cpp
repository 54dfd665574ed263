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
  edges_.resize(begins_[cells]);
  next_.assign(begins_.begin(), begins_.end() - 1);
  all_.clear();
  for (std::uint32_t k = 0; k < edges.size(); ++k) {
    const OutlineEdge& e = edges[k];
    const auto [x0, x1] = std::minmax(e.at_low.x(), e.at_high.x());
    const auto [y0, y1] = std::minmax(e.at_low.y(), e.at_high.y());
    const double near = std::max(e.at_low.z(), e.at_high.z());
    const Entry entry{float_below(x0 - rounding), float_above(x1 + rounding),   float_below(y0 - rounding),
                      float_above(y1 + rounding), float_above(near + rounding), k};
    all_.push_back(entry);
    grid_.visit_line(e.at_low, e.at_high, rounding, [&](std::size_t cell) { edges_[next_[cell]++] = entry; });
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
    const std::size_t first = static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.columns);
    count += begins_[first + static_cast<std::size_t>(c.x1) + 1] - begins_[first + static_cast<std::size_t>(c.x0)];
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

}  // namespace lrcs
