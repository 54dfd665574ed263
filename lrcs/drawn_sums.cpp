#include "lrcs/drawn_sums.h"

#include <algorithm>

namespace lrcs {

DrawnSums::DrawnSums(const Target& target) : drawing_(target.mesh), returns_(target) {}

const std::vector<RowSum>& DrawnSums::draw(const RowGrid& grid) {
  drawing_.look_along(grid);
  returns_.look_along(grid.toward, grid.toward);
  sums_.assign(grid.rows, {});
  largest_ = runs_ = places_ = 0.0;
  while (drawing_.draw_more())
    for (std::uint32_t row = drawing_.first_row(); row < drawing_.last_row(); ++row)
      sums_[row] = sum_of(drawing_.row(row));
  return sums_;
}

// Runs of one facet at once.
RowSum DrawnSums::sum_of(std::span<const Drawn> row) {
  RowSum sum;
  for (std::size_t k = 0; k < row.size();) {
    const std::uint32_t facet = row[k].facet;
    const std::size_t first = k;
    std::size_t tied = 0;
    for (; k < row.size() && row[k].facet == facet; ++k) tied += row[k].tied;
    if (facet == Drawn::nothing) continue;
    const double value = returns_.of(facet);
    const auto places = static_cast<double>(k - first);
    largest_ = std::max(largest_, value);
    sum.value += places * value;
    sum.area += places;
    runs_ += 1.0;
    places_ += places;
    if (tied > 0) sum.doubt += static_cast<double>(tied) * returns_.range_in_plane_of(facet);
  }
  return sum;
}

}  // namespace lrcs
