#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "lrcs/cell_grid.h"
#include "lrcs/seen_facet.h"
#include "lrcs/surface.h"
#include "lrcs/view_outline.h"

namespace lrcs {

// What certainly cannot be seen, found coarsely: for each cell of a grid across a view, a depth behind which all is
// hidden.
// Facets and outline edges come from near to far. Between two gaps in depth stands a cluster of them, as far as the
// cell is concerned. If it holds no outline edge, but a facet that certainly has a place in the cell, its facets go on
// across each of their edges within the cell: they cover all of it. So does a single facet that holds the whole cell.
// Nothing else is asked, so facets may pass through each other. law: what is said to be hidden is hidden; not all that
// is hidden is said to be.
class CoverGrid {
 public:
  void find(const Surface& surface, const ViewOutline& view);

  // Is a facet certainly hidden, all of it? `ids`: its corners. Not said of thin ones, and of those seen nearly
  // edge-on.
  [[nodiscard]] bool hides(const ViewOutline& view, const std::array<std::uint32_t, 3>& ids) const;

 private:
  static constexpr float nothing = -std::numeric_limits<float>::infinity();
  struct Cell {
    float cover = nothing;      // all behind this is hidden
    float farthest = -nothing;  // of the cluster at hand
    bool present = false;       // does a facet of it certainly have a place in the cell?
    bool tainted = false;       // may an outline edge of it?
  };

  struct Item {
    enum Kind : std::uint32_t { edge, facet, node };  // index: of view.edges(), of a facet, of a node of the tree
    double near;
    std::uint32_t index;
    Kind kind;
  };

  void lay_out(const ViewOutline& view, const Surface& surface);
  void list_items(const Surface& surface, const ViewOutline& view);
  void order_items(const double* z, std::size_t vertices);
  void take_facet(const ViewOutline& view, const std::array<std::uint32_t, 3>& ids, double front);
  void take_node(const Surface& surface, const ViewOutline& view, const FacetTree::Node& node, double front);
  void take_edge(const OutlineEdge& edge, double front);
  [[nodiscard]] static bool is_open(Cell& cell, double front);
  [[nodiscard]] bool has_middle(const SeenFacet& facet, int column, int row) const;
  [[nodiscard]] bool is_small(const SeenFacet& facet) const;
  template <class Visit>
  void visit_cells(const SeenFacet& facet, const Visit& visit) const;
  [[nodiscard]] std::pair<double, double> span_of_row(const SeenFacet& facet, int row) const;
  [[nodiscard]] std::pair<double, double> middle_of(int column, int row) const {
    return {grid_.x0 + (column + 0.5) * size_, grid_.y0 + (row + 0.5) * size_};
  }

  CellGrid grid_;
  double size_ = 0.0, rounding_ = 0.0;  // of a cell; of the view
  std::vector<Cell> cells_;             // none: nothing is said
  std::vector<Item> items_, ordered_;
  std::vector<std::size_t> begins_;
};

}  // namespace lrcs
