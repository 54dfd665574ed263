#include "view/hemisphere_surface.h"

#include <algorithm>
#include <cmath>

#include "view/canvas.h"

namespace lrcs {
namespace {

constexpr Colour wall_grey{0.93, 0.93, 0.93};
constexpr Colour wall_line{0.72, 0.72, 0.72};

// A segment as a thin tile.
Tile stroke(const Point& from, const Point& to, double width, const Colour& colour) {
  const double length = std::max(std::hypot(to.x - from.x, to.y - from.y), 1e-9);
  const double dx = -0.5 * width * (to.y - from.y) / length, dy = 0.5 * width * (to.x - from.x) / length;
  return {{{from.x + dx, from.y + dy}, {to.x + dx, to.y + dy}, {to.x - dx, to.y - dy}, {from.x - dx, from.y - dy}},
          colour};
}

Colour darker(const Colour& colour, double factor) {
  return {factor * colour.red, factor * colour.green, factor * colour.blue};
}

bool is_multiple(double value, double step) {
  return std::abs(value - step * std::round(value / step)) < 1e-6;
}

class Surface {
 public:
  Surface(const HemisphereValues& values, double full_scale, const HemisphereView& view)
      : values_(values), full_scale_(full_scale), view_(view) {}

  [[nodiscard]] std::vector<Tile> tiles() const {
    std::vector<Tile> tiles;
    for (const Cell& cell : cells_far_to_near()) add_cell(tiles, cell);
    for (const Cell& cell : cells_far_to_near())
      if (cell.theta + 2 == values_.theta_r_deg.size() && cell.nearness > 0.0) add_wall(tiles, cell);
    return tiles;
  }

 private:
  // Between rings theta, theta + 1 and rays phi, phi + 1.
  struct Cell {
    std::size_t theta, phi;
    double nearness;
  };

  // Past the last ray comes the first, a turn later.
  [[nodiscard]] double phi_deg(std::size_t p) const {
    const std::size_t rays = values_.phi_deg.size();
    return p < rays ? values_.phi_deg[p] : values_.phi_deg[p - rays] + 360.0;
  }

  [[nodiscard]] double height(std::size_t t, std::size_t p) const {
    const std::size_t rays = values_.phi_deg.size();
    return values_.value[t * rays + p % rays] / full_scale_;
  }

  [[nodiscard]] Point corner(std::size_t t, std::size_t p) const {
    return view_.at(values_.theta_r_deg[t], phi_deg(p), height(t, p));
  }

  [[nodiscard]] std::vector<Cell> cells_far_to_near() const {
    std::vector<Cell> cells;
    for (std::size_t t = 0; t + 1 < values_.theta_r_deg.size(); ++t)
      for (std::size_t p = 0; p < values_.phi_deg.size(); ++p) {
        const double theta = 0.5 * (values_.theta_r_deg[t] + values_.theta_r_deg[t + 1]);
        cells.push_back({t, p, view_.nearness(theta, 0.5 * (phi_deg(p) + phi_deg(p + 1)))});
      }
    std::stable_sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) { return a.nearness < b.nearness; });
    return cells;
  }

  // A line is drawn with both cells beside it: the nearer one, painted later, would cover half of it.
  void add_cell(std::vector<Tile>& tiles, const Cell& cell) const {
    const auto [t, p, nearness] = cell;
    const double mean = 0.25 * (height(t, p) + height(t + 1, p) + height(t, p + 1) + height(t + 1, p + 1));
    const Colour colour = viridis(std::clamp(mean, 0.0, 1.0));
    tiles.push_back({{corner(t, p), corner(t + 1, p), corner(t + 1, p + 1), corner(t, p + 1)}, colour});
    constexpr double width = 2.0;
    const Colour line = darker(colour, 0.55);
    for (const std::size_t ring : {t, t + 1})
      if (ring > 0 && is_multiple(values_.theta_r_deg[ring], 10.0))
        tiles.push_back(stroke(corner(ring, p), corner(ring, p + 1), width, line));
    for (const std::size_t ray : {p, p + 1})
      if (is_multiple(phi_deg(ray), 30.0)) tiles.push_back(stroke(corner(t, ray), corner(t + 1, ray), width, line));
  }

  void add_wall(std::vector<Tile>& tiles, const Cell& cell) const {
    const std::size_t rim = cell.theta + 1, p = cell.phi;
    const double theta = values_.theta_r_deg[rim];
    const Point low = view_.at(theta, phi_deg(p), 0.0), next_low = view_.at(theta, phi_deg(p + 1), 0.0);
    const Point high = corner(rim, p), next_high = corner(rim, p + 1);
    tiles.push_back({{low, next_low, next_high, high}, wall_grey});
    for (const std::size_t ray : {p, p + 1})
      if (is_multiple(phi_deg(ray), 30.0))
        tiles.push_back(stroke(view_.at(theta, phi_deg(ray), 0.0), corner(rim, ray), 2.0, wall_line));
    tiles.push_back(stroke(low, next_low, 3.0, ink));
    tiles.push_back(stroke(high, next_high, 2.0, ink));
  }

  const HemisphereValues& values_;
  double full_scale_;
  const HemisphereView& view_;
};

}  // namespace

std::vector<Tile> hemisphere_surface(const HemisphereValues& values, double full_scale, const HemisphereView& view) {
  return Surface(values, full_scale, view).tiles();
}

}  // namespace lrcs
