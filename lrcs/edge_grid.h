#pragma once
#include <cstdint>
#include <vector>

#include "lrcs/cell_grid.h"
#include "lrcs/edge_sieve.h"
#include "lrcs/view_outline.h"

namespace lrcs {

// The outline edges of a view in the cells of a grid across it.
class EdgeGrid {
 public:
  // `rounding`: error of the coordinates in the view.
  void fill(const std::vector<OutlineEdge>& edges, double rounding);

  struct Cells {  // columns and rows [low, high]
    int x0, x1, y0, y1;
  };
  [[nodiscard]] Cells cells(double x0, double x1, double y0, double y1) const;
  // The edges in cells [x0, x1] of a row, those of one cell after those of another: places [first, last) of ends().
  struct Run {
    std::size_t first, last;
  };
  [[nodiscard]] Run run(int row, int x0, int x1) const {
    return {begins_[grid_.cell(x0, row)], begins_[grid_.cell(x1, row) + 1]};
  }
  [[nodiscard]] const EdgeEnds& ends() const { return ends_; }
  // All edges, each once.
  [[nodiscard]] const EdgeEnds& each() const { return each_; }
  // How many entries the cells have together.
  [[nodiscard]] std::size_t entries(const Cells& cells) const;
  // Does any cell hold an edge?
  [[nodiscard]] bool any(const Cells& cells) const;
  // Does any cell hold an edge that may reach as near as z?
  [[nodiscard]] bool any_before(const Cells& cells, double z) const;

 private:
  void lay_out(const std::vector<OutlineEdge>& edges, double rounding);
  [[nodiscard]] std::size_t entries_needed(const std::vector<OutlineEdge>& edges, double rounding) const;
  void coarsen();

  CellGrid grid_;
  std::vector<std::uint32_t> begins_, next_;
  EdgeEnds ends_, each_;
  std::vector<float> near_;                   // of each cell
  std::vector<std::uint32_t> filled_before_;  // summed over the cells left of and below
};

}  // namespace lrcs
