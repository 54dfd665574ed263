#include "lrcs/cover_grid.h"

#include <algorithm>
#include <cmath>

namespace lrcs {

// A facet in the view.
struct CoverGrid::SeenFacet {
  SeenFacet(const ViewOutline& view, const std::array<std::uint32_t, 3>& ids) {
    for (std::size_t k = 0; k < 3; ++k) {
      x[k] = view.x()[ids[k]];
      y[k] = view.y()[ids[k]];
      z[k] = view.z()[ids[k]];
    }
    far = std::min({z[0], z[1], z[2]}) - view.rounding();
    near = std::max({z[0], z[1], z[2]}) + view.rounding();
  }

  // Twice its area across the view, and whether that is hardly known: thin, or seen nearly edge-on.
  [[nodiscard]] double area() const { return (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]); }
  [[nodiscard]] double sides() const {
    return std::abs(x[1] - x[0]) + std::abs(y[1] - y[0]) + std::abs(x[2] - x[0]) + std::abs(y[2] - y[0]);
  }
  [[nodiscard]] bool is_thin() const {
    // Else rounding in the slopes moves the plane by less than 2^-28 of the facet's depth.
    constexpr double too_thin = 0x1p-20;
    return !(std::abs(area()) > too_thin * sides() * sides());
  }

  std::array<double, 3> x, y, z;
  double near, far;  // rounding included
};

namespace {

constexpr int narrow = 2;  // as few columns as this are not worth a closer look

float below(double x) {
  const auto rounded = static_cast<float>(x);
  return rounded <= x ? rounded : std::nextafter(rounded, -std::numeric_limits<float>::infinity());
}

using SeenFacet = CoverGrid::SeenFacet;

// What a facet is in cells that are smaller than it: squares of side 2 half about places (x, y).
class FacetInCells {
 public:
  FacetInCells(const SeenFacet& facet, double half, double rounding) : facet_(facet) {
    const auto& [x, y, z, near, far] = facet;
    const double ax = x[1] - x[0], ay = y[1] - y[0], bx = x[2] - x[0], by = y[2] - y[0];
    const double area = facet.area(), sides = facet.sides();
    has_plane_ = !facet.is_thin();
    if (!has_plane_) return;
    const double az = z[1] - z[0], bz = z[2] - z[0];
    z_x_ = (az * by - bz * ay) / area;
    z_y_ = (bz * ax - az * bx) / area;
    u_x_ = by / area;
    u_y_ = -bx / area;
    v_x_ = -ay / area;
    v_y_ = ax / area;
    const double slopes = std::abs(z_x_) + std::abs(z_y_);
    spread_ = slopes * (half + rounding) + 0x1p-28 * (near - far) + 4.0 * rounding * (1.0 + slopes);
    margin_ = 0x1p-20 + 8.0 * rounding * sides / std::abs(area);
    const double turn = std::max({std::abs(u_x_) + std::abs(u_y_), std::abs(v_x_) + std::abs(v_y_),
                                  std::abs(u_x_ + v_x_) + std::abs(u_y_ + v_y_)});
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
    const double u = u_x_ * dx + u_y_ * dy, v = v_x_ * dx + v_y_ * dy;
    const double least = std::min({u, v, 1.0 - u - v});
    return {has_plane_ && least > 2.0 * margin_, has_plane_ && least > whole_margin_};
  }

 private:
  [[nodiscard]] double depth(double x, double y) const {
    return facet_.z[0] + z_x_ * (x - facet_.x[0]) + z_y_ * (y - facet_.y[0]);
  }

  const SeenFacet& facet_;
  bool has_plane_ = false;
  double z_x_ = 0.0, z_y_ = 0.0;                          // change of z along the plane
  double u_x_ = 0.0, u_y_ = 0.0, v_x_ = 0.0, v_y_ = 0.0;  // change of the facet's own coordinates
  double spread_ = 0.0;                                   // of z within a cell
  double margin_ = 0.0, whole_margin_ = 0.0;              // of the facet's own coordinates
};

}  // namespace

int CoverGrid::column_of(double x) const {
  return std::clamp(static_cast<int>((x - x0_) * per_), 0, columns_ - 1);
}
int CoverGrid::row_of(double y) const {
  return std::clamp(static_cast<int>((y - y0_) * per_), 0, rows_ - 1);
}

void CoverGrid::find(const Surface& surface, const ViewOutline& view) {
  lay_out(view, surface);
  // Where outlines are few, few facets are cut by any, and this would take longer than it saves.
  constexpr std::size_t few = 32;
  if (few * view.edges().size() < surface.occluders.size()) return;
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
  x0_ = *x0;
  y0_ = *y0;
  const double width = *x1 - *x0, height = *y1 - *y0;
  // Finer ones find more, but take longer than that saves.
  const double across = std::clamp(std::sqrt(static_cast<double>(surface.occluders.size())), 16.0, 64.0);
  size_ = std::max(width, height) / across;
  per_ = size_ > 0.0 ? 1.0 / size_ : 0.0;
  columns_ = static_cast<int>(width * per_) + 1;
  rows_ = static_cast<int>(height * per_) + 1;
  cells_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), {});
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
    Cell& c = cells_[cell(column, row)];
    if (!is_open(c, front)) return true;
    c.farthest = std::min(c.farthest, below(facet.far));
    c.present = c.present || has_middle(facet, column, row);
    return true;
  };
  if (is_small(facet)) return visit_cells(facet, small);
  const FacetInCells in_cells(facet, 0.5 * size_, rounding_);
  const auto large = [&](int column, int row) {
    Cell& c = cells_[cell(column, row)];
    if (!is_open(c, front)) return true;
    const double x = x0_ + (column + 0.5) * size_, y = y0_ + (row + 0.5) * size_;
    const float far = below(in_cells.farthest(x, y));
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
  const float far = below(box.low.z());
  std::uint32_t counted = node.first;
  while (view.counts(counted) == 0) ++counted;
  const SeenFacet facet(view, surface.occluders.facets[counted]);
  for (int row = row_of(box.low.y()); row <= row_of(box.high.y()); ++row)
    for (int column = column_of(box.low.x()); column <= column_of(box.high.x()); ++column) {
      Cell& c = cells_[cell(column, row)];
      if (!is_open(c, front)) continue;
      c.farthest = std::min(c.farthest, far);
      c.present = c.present || has_middle(facet, column, row);
    }
}

// Is the middle of a facet certainly in a cell?
bool CoverGrid::has_middle(const SeenFacet& facet, int column, int row) const {
  const double x = x0_ + (column + 0.5) * size_, y = y0_ + (row + 0.5) * size_;
  const double inside = 0.495 * size_ - rounding_;
  return std::abs((facet.x[0] + facet.x[1] + facet.x[2]) / 3.0 - x) < inside &&
         std::abs((facet.y[0] + facet.y[1] + facet.y[2]) / 3.0 - y) < inside;
}

void CoverGrid::take_edge(const OutlineEdge& e, double front) {
  const bool rises = e.at_low.y() <= e.at_high.y();
  const Vec3 &a = rises ? e.at_low : e.at_high, &b = rises ? e.at_high : e.at_low;
  const double x0 = std::min(a.x(), b.x()) - rounding_, x1 = std::max(a.x(), b.x()) + rounding_;
  const int row0 = row_of(a.y() - rounding_), row1 = row_of(b.y() + rounding_);
  const double slope = row1 > row0 ? (b.x() - a.x()) / (b.y() - a.y()) : 0.0;
  const float far = below(std::min(a.z(), b.z()) - rounding_);
  for (int row = row0; row <= row1; ++row) {
    double from = x0, to = x1;
    if (row1 > row0) {
      const double low = y0_ + row * size_ - rounding_, high = y0_ + (row + 1) * size_ + rounding_;
      const double at_low = a.x() + slope * (low - a.y()), at_high = a.x() + slope * (high - a.y());
      from = std::max(from, std::min(at_low, at_high) - rounding_);
      to = std::min(to, std::max(at_low, at_high) + rounding_);
    }
    const int last = column_of(to);
    for (int column = column_of(from); column <= last; ++column) {
      Cell& c = cells_[cell(column, row)];
      if (!is_open(c, front)) continue;
      c.farthest = std::min(c.farthest, far);
      c.tainted = true;
    }
  }
}

bool CoverGrid::is_small(const SeenFacet& f) const {
  const auto [x0, x1] = std::minmax({f.x[0], f.x[1], f.x[2]});
  const auto [y0, y1] = std::minmax({f.y[0], f.y[1], f.y[2]});
  return x1 - x0 < size_ && y1 - y0 < size_;
}

// The cells that a facet may have a part in, until `visit` has had enough.
template <class Visit>
void CoverGrid::visit_cells(const SeenFacet& f, const Visit& visit) const {
  const auto [x0, x1] = std::minmax({f.x[0], f.x[1], f.x[2]});
  const auto [y0, y1] = std::minmax({f.y[0], f.y[1], f.y[2]});
  const int column0 = column_of(x0 - rounding_), column1 = column_of(x1 + rounding_);
  const int row0 = row_of(y0 - rounding_), row1 = row_of(y1 + rounding_);
  const bool all = column1 - column0 < narrow || row0 == row1;
  for (int row = row0; row <= row1; ++row) {
    int from = column0, to = column1;
    if (!all) {
      const auto [low, high] = span_of_row(f, row);
      from = column_of(std::max(low, x0) - rounding_);
      to = column_of(std::min(high, x1) + rounding_);
    }
    for (int column = from; column <= to; ++column)
      if (!visit(column, row)) return;
  }
}

// Where a facet's sides run in a row of cells: from, to.
std::pair<double, double> CoverGrid::span_of_row(const SeenFacet& f, int row) const {
  const double low = y0_ + row * size_ - rounding_, high = y0_ + (row + 1) * size_ + rounding_;
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
  const SeenFacet facet(view, ids);
  if (facet.is_thin()) return false;
  bool hidden = true;
  if (is_small(facet)) {
    visit_cells(facet, [&](int column, int row) { return hidden = cells_[cell(column, row)].cover > facet.near; });
    return hidden;
  }
  const FacetInCells in_cells(facet, 0.5 * size_, rounding_);
  visit_cells(facet, [&](int column, int row) {
    const double x = x0_ + (column + 0.5) * size_, y = y0_ + (row + 0.5) * size_;
    return hidden = cells_[cell(column, row)].cover > in_cells.nearest(x, y);
  });
  return hidden;
}

}  // namespace lrcs
