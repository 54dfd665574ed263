#include "lrcs/row_drawing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lrcs {
namespace {

constexpr std::uint32_t places_a_band = 1U << 16U;  // with their heights they fit the cache of a core
constexpr std::uint32_t tile = 8;                   // rows and columns
constexpr double together = 0x1p-40;

// The first whole number not below x. domain: 0..2^31; library calls take longer.
std::uint32_t ceiling(double x) {
  const auto whole = static_cast<std::int32_t>(x);
  return static_cast<std::uint32_t>(whole + (whole < x ? 1 : 0));
}

}  // namespace

struct RowDrawing::Edge {
  Edge(const Vec3& from, const Vec3& to) : x(from.x()), y(from.y()), slope((to.x() - x) / (to.y() - y)) {}
  [[nodiscard]] double at(double row) const { return x + (row - y) * slope; }
  double x, y, slope;
};

RowDrawing::RowDrawing(const FacetMesh& mesh)
    : mesh_(mesh), placement_(mesh), placed_(mesh.positions.size()), above_(mesh.positions.size()) {}

void RowDrawing::look_along(const RowGrid& grid) {
  grid_ = grid;
  rows_a_band_ = std::clamp(places_a_band / grid.columns, 1U, std::max(grid.rows, 1U));
  first_ = last_ = 0;
  offsets_.resize(grid.rows);
  for (std::uint32_t row = 0; row < grid.rows; ++row) offsets_[row] = RowGrid::offset(row);
  place();
  sort_into_bands();
}

void RowDrawing::place() {
  const double per_step = 1.0 / grid_.step;
  const Vec3 across = per_step * placement_.scale * grid_.right, up = per_step * placement_.scale * grid_.up;
  const Vec3 toward = placement_.scale * grid_.toward;
  const Vec3 origin = placement_.centre + grid_.corner / placement_.scale;
  for (std::size_t k = 0; k < placed_.size(); ++k) {
    const Vec3 p = mesh_.positions[k] - origin;
    placed_[k] = {across.dot(p), up.dot(p), toward.dot(p)};
    // Those of no facet may lie anywhere.
    above_[k] = ceiling(std::clamp(placed_[k].y() - 0.5, 0.0, static_cast<double>(grid_.rows)));
  }
}

// A facet stands in every band whose rows it meets, fronts before backs; most meet no row at all where facets are
// small.
void RowDrawing::sort_into_bands() {
  const std::uint32_t bands = (grid_.rows + rows_a_band_ - 1) / rows_a_band_;
  if (fronts_.size() < bands) {
    fronts_.resize(bands);
    backs_.resize(bands);
  }
  for (std::uint32_t band = 0; band < bands; ++band) {
    fronts_[band].clear();
    backs_[band].clear();
  }
  for (std::uint32_t f = 0; f < mesh_.size(); ++f) {
    const auto [a, b, c] = mesh_.facets[f];
    const std::uint32_t low = std::min({above_[a], above_[b], above_[c]});
    const std::uint32_t high = std::min(std::max({above_[a], above_[b], above_[c]}), grid_.rows);
    if (low >= high) continue;
    auto& facing = mesh_.normals[f].dot(grid_.toward) < 0.0 ? backs_ : fronts_;
    const std::uint32_t last = (high - 1) / rows_a_band_;
    for (std::uint32_t band = low / rows_a_band_; band <= last; ++band) facing[band].push_back(f);
  }
}

bool RowDrawing::draw_more() {
  if (last_ >= grid_.rows) return false;
  const std::uint32_t band = last_ / rows_a_band_;
  first_ = last_;
  last_ = std::min(first_ + rows_a_band_, grid_.rows);
  const std::size_t places = std::size_t{last_ - first_} * grid_.columns;
  heights_.assign(places, -std::numeric_limits<double>::infinity());
  drawn_.assign(places, {});
  for (const std::uint32_t facet : fronts_[band]) draw(facet);
  find_lowest();
  for (const std::uint32_t facet : backs_[band])
    if (!is_hidden(facet)) draw(facet);
  return true;
}

void RowDrawing::find_lowest() {
  tiles_ = (grid_.columns + tile - 1) / tile;
  lowest_.assign(std::size_t{tiles_} * ((last_ - first_ + tile - 1) / tile), std::numeric_limits<double>::infinity());
  for (std::uint32_t row = 0; row < last_ - first_; ++row) {
    const double* heights = heights_.data() + std::size_t{row} * grid_.columns;
    double* lowest = lowest_.data() + std::size_t{row / tile} * tiles_;
    for (std::uint32_t c = 0; c < grid_.columns; ++c) lowest[c / tile] = std::min(lowest[c / tile], heights[c]);
  }
}

// By all that is drawn already, over the box around it.
bool RowDrawing::is_hidden(std::uint32_t facet) const {
  const auto [i, j, k] = mesh_.facets[facet];
  const Vec3 &a = placed_[i], &b = placed_[j], &c = placed_[k];
  const double height = std::max({a.z(), b.z(), c.z()}) + together;
  const double left = std::min({a.x(), b.x(), c.x()}) - 1.0, right = std::max({a.x(), b.x(), c.x()});
  const std::uint32_t low = std::max(std::min({above_[i], above_[j], above_[k]}), first_) - first_;
  const std::uint32_t high = std::min(std::max({above_[i], above_[j], above_[k]}), last_) - first_;
  const std::uint32_t from = ceiling(std::max(left, 0.0)) / tile, to = std::min(ceiling(right) / tile, tiles_ - 1);
  for (std::uint32_t row = low / tile; row <= (high - 1) / tile; ++row)
    for (std::uint32_t column = from; column <= to; ++column)
      if (lowest_[std::size_t{row} * tiles_ + column] <= height) return false;
  return true;
}

// Corners from the lowest up; the side from the first to the last is met by all rows, the others by some each.
void RowDrawing::draw(std::uint32_t facet) {
  std::array<std::uint32_t, 3> k = mesh_.facets[facet];
  const auto sort = [&](std::uint32_t& low, std::uint32_t& high) {
    const bool turned = above_[low] > above_[high];
    const std::uint32_t before = low;
    low = turned ? high : low;
    high = turned ? before : high;
  };
  sort(k[0], k[1]);
  sort(k[1], k[2]);
  sort(k[0], k[1]);
  const Vec3 &a = placed_[k[0]], &b = placed_[k[1]], &c = placed_[k[2]];
  Plane plane;
  if (!find_plane(a, b, c, plane)) return;
  const Edge along(a, c);
  const std::uint32_t low = std::max(above_[k[0]], first_), high = std::min(above_[k[2]], last_);
  const std::uint32_t bend = std::clamp(above_[k[1]], low, high);
  if (low < bend) draw_between(facet, low, bend, along, Edge(a, b), plane);
  if (bend < high) draw_between(facet, bend, high, along, Edge(b, c), plane);
}

// In one place what came first stays, as in the exact way: the one whose front is seen, then the lower number.
void RowDrawing::draw_between(std::uint32_t facet, std::uint32_t low, std::uint32_t high, const Edge& one,
                              const Edge& other, const Plane& plane) {
  for (std::uint32_t row = low; row < high; ++row) {
    const double p = one.at(row + 0.5) - offsets_[row], q = other.at(row + 0.5) - offsets_[row];
    const std::uint32_t from = ceiling(std::min(p, q)), to = std::min(ceiling(std::max(p, q)), grid_.columns);
    const double at_row = plane.height + plane.per_y * (row + 0.5) + plane.per_x * offsets_[row];
    double* heights = heights_.data() + std::size_t{row - first_} * grid_.columns;
    Drawn* drawn = drawn_.data() + std::size_t{row - first_} * grid_.columns;
    for (std::uint32_t k = from; k < to; ++k) {
      const double height = at_row + plane.per_x * k, nearer = height - heights[k];
      if (nearer > together) {
        heights[k] = height;
        drawn[k] = {facet, 0};
      } else if (nearer >= -together && nearer != 0.0) {
        drawn[k].tied = 1;
      }
    }
  }
}

bool RowDrawing::find_plane(const Vec3& a, const Vec3& b, const Vec3& c, Plane& plane) {
  const Vec3 n = (b - a).cross(c - a);
  if (n.z() == 0.0) return false;
  const double per_height = -1.0 / n.z();
  plane.per_x = n.x() * per_height;
  plane.per_y = n.y() * per_height;
  plane.height = a.z() - plane.per_x * a.x() - plane.per_y * a.y();
  return true;
}

}  // namespace lrcs
