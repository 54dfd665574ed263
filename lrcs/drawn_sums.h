#pragma once
#include <vector>

#include "lrcs/known_returns.h"
#include "lrcs/row_drawing.h"
#include "lrcs/row_sums.h"

namespace lrcs {

// Draws a target into the rows of a grid, and sums along them: what RowSums gives of rays, where transmitter and
// receiver stand in one direction.
class DrawnSums {
 public:
  // Keeps a reference.
  explicit DrawnSums(const Target& target);

  // shape: one a row of the grid; valid until the next call.
  const std::vector<RowSum>& draw(const RowGrid& grid);

  // The largest value at any place of the last grid.
  [[nodiscard]] double largest() const { return largest_; }

  // How often a place of it shows another facet than the one before, over the places that show any.
  [[nodiscard]] double variety() const { return places_ > 0.0 ? runs_ / places_ : 1.0; }

 private:
  [[nodiscard]] RowSum sum_of(std::span<const Drawn> row);

  RowDrawing drawing_;
  KnownReturns returns_;
  std::vector<RowSum> sums_;
  double largest_ = 0.0, runs_ = 0.0, places_ = 0.0;
};

}  // namespace lrcs
