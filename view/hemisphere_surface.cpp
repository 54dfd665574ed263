#include "view/hemisphere_surface.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "view/canvas.h"

namespace lrcs {
namespace {

constexpr Colour wall_grey{0.93, 0.93, 0.93};
constexpr Colour wall_line{0.72, 0.72, 0.72};

// A segment as a thin tile.
Tile thick_line(const Point& from, const Point& to, double width, const Colour& colour) {
  const double length = std::max(std::hypot(to.x - from.x, to.y - from.y), 1e-9);
  const double dx = -0.5 * width * (to.y - from.y) / length, dy = 0.5 * width * (to.x - from.x) / length;
  return {{{from.x + dx, from.y + dy}, {to.x + dx, to.y + dy}, {to.x - dx, to.y - dy}, {from.x - dx, from.y - dy}},
          colour};
}

// Of lines on the surface: darker than it, but lighter where it is darkest.
Colour line_colour(double height) {
  constexpr double darkest = 0.06, darkness = 0.55, lightness = 0.3;
  const Colour colour = viridis(std::clamp(height, 0.0, 1.0));
  const double factor = height < darkest ? 1.0 - lightness : darkness;
  const double white_share = height < darkest ? lightness : 0.0;
  return {factor * colour.red + white_share, factor * colour.green + white_share, factor * colour.blue + white_share};
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
    const std::vector<Cell> cells = cells_far_to_near();
    for (const Cell& cell : cells) add_cell(tiles, cell);
    for (const Cell& cell : cells)
      if (is_near_rim(cell)) add_wall(tiles, cell);
    for (const Cell& cell : cells)
      if (is_near_rim(cell)) add_wall_lines(tiles, cell);
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

  [[nodiscard]] bool is_near_rim(const Cell& cell) const {
    return cell.theta + 2 == values_.theta_r_deg.size() && cell.nearness > 0.0;
  }

  // A cell over which the height changes much is painted in pieces, so that colours run smoothly.
  [[nodiscard]] std::size_t pieces_along(double change) const {
    constexpr double one_shade = 0.008, most = 16.0;
    return static_cast<std::size_t>(std::clamp(std::ceil(std::abs(change) / one_shade), 1.0, most));
  }

  void add_pieces(std::vector<Tile>& tiles, std::size_t t, std::size_t p) const {
    const std::array<double, 4> h{height(t, p), height(t, p + 1), height(t + 1, p), height(t + 1, p + 1)};
    const std::array<Point, 4> c{corner(t, p), corner(t, p + 1), corner(t + 1, p), corner(t + 1, p + 1)};
    const auto between = [](double a00, double a01, double a10, double a11, double u, double v) {
      return std::lerp(std::lerp(a00, a01, v), std::lerp(a10, a11, v), u);
    };
    const auto place = [&](double u, double v) {
      return Point{between(c[0].x, c[1].x, c[2].x, c[3].x, u, v), between(c[0].y, c[1].y, c[2].y, c[3].y, u, v)};
    };
    const auto rows = static_cast<double>(pieces_along(std::max(std::abs(h[2] - h[0]), std::abs(h[3] - h[1]))));
    const auto columns = static_cast<double>(pieces_along(std::max(std::abs(h[1] - h[0]), std::abs(h[3] - h[2]))));
    for (double i = 0.0; i < rows; i += 1.0)
      for (double k = 0.0; k < columns; k += 1.0) {
        const double u = i / rows, next_u = (i + 1.0) / rows, v = k / columns, next_v = (k + 1.0) / columns;
        const double mean = between(h[0], h[1], h[2], h[3], 0.5 * (u + next_u), 0.5 * (v + next_v));
        tiles.push_back({{place(u, v), place(next_u, v), place(next_u, next_v), place(u, next_v)},
                         viridis(std::clamp(mean, 0.0, 1.0))});
      }
  }

  void add_line(std::vector<Tile>& tiles, std::size_t t, std::size_t p, std::size_t to_t, std::size_t to_p) const {
    constexpr double width = 2.0;
    const Colour colour = line_colour(0.5 * (height(t, p) + height(to_t, to_p)));
    tiles.push_back(thick_line(corner(t, p), corner(to_t, to_p), width, colour));
  }

  // A line is drawn with both cells beside it: the nearer one, painted later, would cover half of it.
  void add_cell(std::vector<Tile>& tiles, const Cell& cell) const {
    const std::size_t t = cell.theta, p = cell.phi;
    add_pieces(tiles, t, p);
    for (const std::size_t ring : {t, t + 1})
      if (ring > 0 && is_multiple(values_.theta_r_deg[ring], 10.0)) add_line(tiles, ring, p, ring, p + 1);
    for (const std::size_t ray : {p, p + 1})
      if (is_multiple(phi_deg(ray), 30.0)) add_line(tiles, t, ray, t + 1, ray);
  }

  [[nodiscard]] Point foot(std::size_t p) const { return view_.at(values_.theta_r_deg.back(), phi_deg(p), 0.0); }

  void add_wall(std::vector<Tile>& tiles, const Cell& cell) const {
    const std::size_t rim = cell.theta + 1, p = cell.phi;
    tiles.push_back({{foot(p), foot(p + 1), corner(rim, p + 1), corner(rim, p)}, wall_grey});
  }

  void add_wall_lines(std::vector<Tile>& tiles, const Cell& cell) const {
    const std::size_t rim = cell.theta + 1, p = cell.phi;
    if (is_multiple(phi_deg(p), 30.0)) tiles.push_back(thick_line(foot(p), corner(rim, p), 2.0, wall_line));
    tiles.push_back(thick_line(foot(p), foot(p + 1), 3.0, ink));
    tiles.push_back(thick_line(corner(rim, p), corner(rim, p + 1), 2.0, ink));
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
