#include "lrcs/cover_grid.h"

#include <algorithm>
#include <cmath>

namespace lrcs {

namespace {

constexpr int narrow = 2;  // as few columns as this are not worth a closer look

// Is its plane hardly known, for it is thin or seen nearly edge-on? Else rounding moves the plane, over the facet, by
// less than 2^-28 of its depth: that of the area and that of the slopes' products by less than 4 u 2^20 = 2^-31 each.
bool is_thin(const SeenFacet& facet) {
  constexpr double too_thin = 0x1p-20;
  return !(std::abs(facet.area()) > too_thin * facet.sides() * facet.sides());
}

// What a facet is in cells that are smaller than it: squares of side 2 half about places (x, y).
class FacetInCells {
 public:
  FacetInCells(const SeenFacet& facet, double half, double rounding) : facet_(facet), has_plane_(!is_thin(facet)) {
    if (!has_plane_) return;
    own_ = facet.own_coordinates();
    const double az = facet.z[1] - facet.z[0], bz = facet.z[2] - facet.z[0];
    z_x_ = az * own_.u_x + bz * own_.v_x;
    z_y_ = az * own_.u_y + bz * own_.v_y;
    const double slopes = std::abs(z_x_) + std::abs(z_y_);
    spread_ = slopes * (half + rounding) + 0x1p-28 * (facet.near - facet.far) + 4.0 * rounding * (1.0 + slopes);
    // As FacetSight; and of a plane that is known so well, u and v are known to 2^-30.
    margin_ = 0x1p-20 + 8.0 * rounding * facet.sides() / std::abs(facet.area());
    const double turn = std::max({std::abs(own_.u_x) + std::abs(own_.u_y), std::abs(own_.v_x) + std::abs(own_.v_y),
                                  std::abs(own_.u_x + own_.v_x) + std::abs(own_.u_y + own_.v_y)});
    whole_margin_ = 2.0 * margin_ + turn * (half + rounding);
  }

  [[nodiscard]] double nearest(double x, double y) const {
    return has_plane_ ? std::min(facet_.near, depth(x, y) + spread_) : facet_.near;
  }
  [[nodiscard]] double farthest(double x, double y) const {
    return has_plane_ ? std::max(facet_.far, depth(x, y) - spread_) : facet_.far;
  }
  // Does it certainly hold the middle of the cell, and all of it?
  struct Holds {
    bool middle, all;
  };
  [[nodiscard]] Holds holds(double x, double y) const {
    const double dx = x - facet_.x[0], dy = y - facet_.y[0];
    const double u = own_.u_x * dx + own_.u_y * dy, v = own_.v_x * dx + own_.v_y * dy;
    const double least = std::min({u, v, 1.0 - u - v});
    return {has_plane_ && least > 2.0 * margin_, has_plane_ && least > whole_margin_};
  }

 private:
  [[nodiscard]] double depth(double x, double y) const {
    return facet_.z[0] + z_x_ * (x - facet_.x[0]) + z_y_ * (y - facet_.y[0]);
  }

  const SeenFacet& facet_;
  bool has_plane_ = false;
  double z_x_ = 0.0, z_y_ = 0.0;  // change of z along the plane
  SeenFacet::OwnCoordinates own_{};
  double spread_ = 0.0;                       // of z within a cell
  double margin_ = 0.0, whole_margin_ = 0.0;  // of the facet's own coordinates
};

}  // namespace

void CoverGrid::find(const Surface& surface, const ViewOutline& view) {
  cells_.clear();
  // Where outlines are few, few facets are cut by any, and this would take longer than it saves.
  constexpr std::size_t few = 24;
  if (few * view.edges().size() < surface.occluders.size()) return;
  lay_out(view, surface);
  list_items(surface, view);
  order_items(view.z(), surface.x.size());
  double front = -std::numeric_limits<double>::infinity();
  for (std::size_t k = items_.size(); k-- > 0;) {
    front = std::max(front, items_[k].near);
    items_[k].near = front;  // of this one and all that come later
  }
  for (const Item& item : items_) {
    if (item.kind == Item::edge)
      take_edge(view.edges()[item.index], item.near);
    else if (item.kind == Item::facet)
      take_facet(view, surface.occluders.facets[item.index], item.near);
    else
      take_node(surface, view, surface.tree.nodes()[item.index], item.near);
  }
  for (Cell& c : cells_)
    if (c.present && !c.tainted) c.cover = std::max(c.cover, c.farthest);
}

// Square cells.
void CoverGrid::lay_out(const ViewOutline& view, const Surface& surface) {
  const std::size_t vertices = surface.x.size();
  const auto [x0, x1] = std::minmax_element(view.x(), view.x() + vertices);
  const auto [y0, y1] = std::minmax_element(view.y(), view.y() + vertices);
  rounding_ = view.rounding();
  const double width = *x1 - *x0, height = *y1 - *y0;
  // Finer ones find more, but take longer than that saves.
  const double by_facets = std::clamp(std::sqrt(static_cast<double>(surface.occluders.size())), 16.0, 64.0);
  const double by_edges = std::min(1.5 * std::sqrt(static_cast<double>(view.edges().size())), 128.0);
  const double across = std::max(by_facets, by_edges);
  size_ = std::max(width, height) / across;
  const double per = size_ > 0.0 ? 1.0 / size_ : 0.0;
  grid_ = {*x0, *y0, per, per, static_cast<int>(width * per) + 1, static_cast<int>(height * per) + 1};
  cells_.assign(grid_.size(), {});
}

// The outline edges, and the counted facets: many at once where they lie close together.
void CoverGrid::list_items(const Surface& surface, const ViewOutline& view) {
  items_.clear();
  const auto edges = static_cast<std::uint32_t>(view.edges().size());
  for (std::uint32_t e = 0; e < edges; ++e)
    items_.push_back({std::max(view.edges()[e].at_low.z(), view.edges()[e].at_high.z()) + rounding_, e, Item::edge});
  const auto& nodes = surface.tree.nodes();
  for (std::uint32_t k = 0; k < nodes.size();) {
    const FacetTree::Node& node = nodes[k];
    const Box3 box = surface.tree.seen_box(node, view.frame());
    if (box.high.x() - box.low.x() < size_ && box.high.y() - box.low.y() < size_) {
      bool any = false;
      for (std::uint32_t f = node.first; f < node.last && !any; ++f) any = view.counts(f) != 0;
      if (any) items_.push_back({box.high.z(), k, Item::node});
      k = node.skip;
      continue;
    }
    for (std::uint32_t f = node.first; node.leaf && f < node.last; ++f) {
      if (view.counts(f) == 0) continue;
      const auto& ids = surface.occluders.facets[f];
      const double near = std::max({view.z()[ids[0]], view.z()[ids[1]], view.z()[ids[2]]});
      items_.push_back({near + rounding_, f, Item::facet});
    }
    ++k;
  }
}

// From near to far, roughly.
void CoverGrid::order_items(const double* z, std::size_t vertices) {
  constexpr std::size_t runs = 4096;
  const auto [low, high] = std::minmax_element(z, z + vertices);
  const double nearest = *high, per = *high > *low ? static_cast<double>(runs) / (*high - *low) : 0.0;
  const auto run_of = [&](const Item& item) {
    return static_cast<std::size_t>(std::clamp((nearest - item.near) * per, 0.0, static_cast<double>(runs - 1)));
  };
  begins_.assign(runs + 1, 0);
  for (const Item& item : items_) ++begins_[run_of(item) + 1];
  for (std::size_t k = 0; k < runs; ++k) begins_[k + 1] += begins_[k];
  ordered_.resize(items_.size());
  for (const Item& item : items_) ordered_[begins_[run_of(item)]++] = item;
  items_.swap(ordered_);
}

// `front`: nothing that comes from now on is nearer. Closes the cluster at hand if there is a gap behind it.
bool CoverGrid::is_open(Cell& cell, double front) {
  if (cell.cover > front) return false;
  if (cell.farthest <= front) return true;
  const bool covered = cell.present && !cell.tainted;
  cell = Cell{.cover = covered ? cell.farthest : cell.cover};
  return !covered;
}

void CoverGrid::take_facet(const ViewOutline& view, const std::array<std::uint32_t, 3>& ids, double front) {
  const SeenFacet facet(view, ids);
  const auto small = [&](int column, int row) {
    Cell& c = cells_[grid_.cell(column, row)];
    if (!is_open(c, front)) return true;
    c.farthest = std::min(c.farthest, float_below(facet.far));
    c.present = c.present || has_middle(facet, column, row);
    return true;
  };
  if (is_small(facet)) return visit_cells(facet, small);
  const FacetInCells in_cells(facet, 0.5 * size_, rounding_);
  const auto large = [&](int column, int row) {
    Cell& c = cells_[grid_.cell(column, row)];
    if (!is_open(c, front)) return true;
    const auto [x, y] = middle_of(column, row);
    const float far = float_below(in_cells.farthest(x, y));
    const auto [middle, all] = in_cells.holds(x, y);
    c.farthest = std::min(c.farthest, far);
    c.present = c.present || middle;
    if (all) c.cover = std::max(c.cover, far);
    return true;
  };
  visit_cells(facet, large);
}

// Facets that lie within a cell's size, all together.
void CoverGrid::take_node(const Surface& surface, const ViewOutline& view, const FacetTree::Node& node, double front) {
  const Box3 box = surface.tree.seen_box(node, view.frame());
  const float far = float_below(box.low.z());
  std::uint32_t counted = node.first;
  while (view.counts(counted) == 0) ++counted;
  const SeenFacet facet(view, surface.occluders.facets[counted]);
  for (int row = grid_.row_of(box.low.y()); row <= grid_.row_of(box.high.y()); ++row)
    for (int column = grid_.column_of(box.low.x()); column <= grid_.column_of(box.high.x()); ++column) {
      Cell& c = cells_[grid_.cell(column, row)];
      if (!is_open(c, front)) continue;
      c.farthest = std::min(c.farthest, far);
      c.present = c.present || has_middle(facet, column, row);
    }
}

// Is the middle of a facet certainly in a cell?
bool CoverGrid::has_middle(const SeenFacet& facet, int column, int row) const {
  const auto [x, y] = middle_of(column, row);
  // Nearer to the middle than the cells' own rounding could matter.
  constexpr double well_inside = 0.495;
  const double inside = well_inside * size_ - rounding_;
  return std::abs((facet.x[0] + facet.x[1] + facet.x[2]) / 3.0 - x) < inside &&
         std::abs((facet.y[0] + facet.y[1] + facet.y[2]) / 3.0 - y) < inside;
}

void CoverGrid::take_edge(const OutlineEdge& e, double front) {
  const float far = float_below(std::min(e.at_low.z(), e.at_high.z()) - rounding_);
  grid_.visit_line(e.at_low, e.at_high, rounding_, [&](std::size_t cell) {
    Cell& c = cells_[cell];
    if (!is_open(c, front)) return;
    c.farthest = std::min(c.farthest, far);
    c.tainted = true;
  });
}

bool CoverGrid::is_small(const SeenFacet& f) const {
  return f.right - f.left < size_ && f.top - f.bottom < size_;
}

// The cells that a facet may have a part in, until `visit` has had enough.
template <class Visit>
void CoverGrid::visit_cells(const SeenFacet& f, const Visit& visit) const {
  const int column0 = grid_.column_of(f.left - rounding_), column1 = grid_.column_of(f.right + rounding_);
  const int row0 = grid_.row_of(f.bottom - rounding_), row1 = grid_.row_of(f.top + rounding_);
  const bool all = column1 - column0 < narrow || row0 == row1;
  for (int row = row0; row <= row1; ++row) {
    int from = column0, to = column1;
    if (!all) {
      const auto [low, high] = span_of_row(f, row);
      from = grid_.column_of(std::max(low, f.left) - rounding_);
      to = grid_.column_of(std::min(high, f.right) + rounding_);
    }
    for (int column = from; column <= to; ++column)
      if (!visit(column, row)) return;
  }
}

// Where a facet's sides run in a row of cells: from, to.
std::pair<double, double> CoverGrid::span_of_row(const SeenFacet& f, int row) const {
  const double low = grid_.bottom_of(row, rounding_), high = grid_.top_of(row, rounding_);
  double from = std::numeric_limits<double>::infinity(), to = -from;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = k < 2 ? k + 1 : 0;
    const std::size_t a = f.y[k] <= f.y[next] ? k : next, b = a == k ? next : k;
    if (f.y[a] > high || f.y[b] < low) continue;
    const double slope = (f.x[b] - f.x[a]) / (f.y[b] - f.y[a]);
    const double at_low = f.y[a] >= low ? f.x[a] : f.x[a] + slope * (low - f.y[a]);
    const double at_high = f.y[b] <= high ? f.x[b] : f.x[a] + slope * (high - f.y[a]);
    from = std::min({from, at_low, at_high});
    to = std::max({to, at_low, at_high});
  }
  return {from, to};
}

bool CoverGrid::hides(const ViewOutline& view, const std::array<std::uint32_t, 3>& ids) const {
  if (cells_.empty()) return false;
  const SeenFacet facet(view, ids);
  if (is_thin(facet)) return false;
  bool hidden = true;
  if (is_small(facet)) {
    visit_cells(facet,
                [&](int column, int row) { return hidden = cells_[grid_.cell(column, row)].cover > facet.near; });
    return hidden;
  }
  const FacetInCells in_cells(facet, 0.5 * size_, rounding_);
  visit_cells(facet, [&](int column, int row) {
    const auto [x, y] = middle_of(column, row);
    return hidden = cells_[grid_.cell(column, row)].cover > in_cells.nearest(x, y);
  });
  return hidden;
}

}  // namespace lrcs
