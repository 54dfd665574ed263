#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "lrcs/cell_grid.h"
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
  // An edge in a cell: its box across the view and its largest z, widened by the rounding, and its number.
  struct Entry {
    float x0, x1, y0, y1, near;
    std::uint32_t edge;
  };
  [[nodiscard]] std::span<const Entry> edges_in(int column, int row) const {
    const std::size_t cell = grid_.cell(column, row);
    return std::span(edges_).subspan(begins_[cell], begins_[cell + 1] - begins_[cell]);
  }
  // All edges, each once.
  [[nodiscard]] const std::vector<Entry>& edges() const { return all_; }
  // How many entries the cells have together.
  [[nodiscard]] std::size_t entries(const Cells& cells) const;
  // Does any cell hold an edge?
  [[nodiscard]] bool any(const Cells& cells) const;

 private:
  void lay_out(const std::vector<OutlineEdge>& edges, double rounding);
  [[nodiscard]] std::size_t entries_needed(const std::vector<OutlineEdge>& edges, double rounding) const;
  void coarsen();

  CellGrid grid_;
  std::vector<std::uint32_t> begins_, next_;
  std::vector<Entry> edges_, all_;
  std::vector<std::uint32_t> filled_before_;  // summed over the cells left of and below
};

}  // namespace lrcs
