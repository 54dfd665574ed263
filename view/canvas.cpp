#include "view/canvas.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "view/dashes.h"

namespace lrcs {
namespace {

double distance_to_segment(const Point& p, const Point& from, const Point& to) {
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double squared = dx * dx + dy * dy;
  const double along = squared > 0.0 ? ((p.x - from.x) * dx + (p.y - from.y) * dy) / squared : 0.0;
  const double t = std::min(1.0, std::max(0.0, along));
  return std::hypot(p.x - from.x - t * dx, p.y - from.y - t * dy);
}

Box box_around(const std::vector<Point>& points, double margin) {
  Box box{points.front(), points.front()};
  for (const Point& p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return {{box.low.x - margin, box.low.y - margin}, {box.high.x + margin, box.high.y + margin}};
}

// Share of the pixel [cell, cell + 1) that lies in [low, high).
double overlap(int cell, double low, double high) {
  return std::max(0.0, std::min(high, cell + 1.0) - std::max(low, static_cast<double>(cell)));
}

std::vector<Point> arc_points(const Point& centre, double radius) {
  constexpr double pixels_a_step = 3.0;
  const int steps = std::max(24, static_cast<int>(2.0 * std::numbers::pi * radius / pixels_a_step));
  std::vector<Point> points;
  for (int step = 0; step <= steps; ++step) {
    const double angle = 2.0 * std::numbers::pi * step / steps;
    points.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return points;
}

double shift(AlignX align, double width) {
  if (align == AlignX::left) return 0.0;
  return align == AlignX::centre ? -0.5 * width : -width;
}

double shift(AlignY align, double cap_height) {
  if (align == AlignY::baseline) return 0.0;
  return align == AlignY::middle ? -0.5 * cap_height : -cap_height;
}

}  // namespace

Canvas::Canvas(int width, int height) : width_(width), height_(height) {
  if (width <= 0 || height <= 0) throw std::invalid_argument("a picture needs a width and a height above zero");
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  rgb_.assign(3 * pixels, 255.0F);
  coverage_.assign(pixels, 0.0F);
  no_clip();
}

Canvas::Canvas(const Picture& ground) : Canvas(ground.width, ground.height) {
  std::copy(ground.rgb.begin(), ground.rgb.end(), rgb_.begin());
}

void Canvas::clip(const Box& box) {
  clip_ = box;
}

void Canvas::no_clip() {
  clip_ = {{0.0, 0.0}, {width(), height()}};
}

std::size_t Canvas::index(int column, int row) const {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column);
}

Canvas::Pixels Canvas::pixels_of(const Box& box) const {
  const auto pixel = [](double place, int end) {
    return static_cast<int>(std::min(static_cast<double>(end), std::max(0.0, place)));
  };
  return {pixel(std::floor(std::max(box.low.x, clip_.low.x)), width_),
          pixel(std::floor(std::max(box.low.y, clip_.low.y)), height_),
          pixel(std::ceil(std::min(box.high.x, clip_.high.x)), width_),
          pixel(std::ceil(std::min(box.high.y, clip_.high.y)), height_)};
}

void Canvas::blend(int column, int row, const Colour& colour, double opacity) {
  const std::size_t first = 3 * index(column, row);
  const auto mix = [&](std::size_t channel, double value) {
    float& old = rgb_[first + channel];
    old = static_cast<float>(old + (255.0 * value - old) * opacity);
  };
  mix(0, colour.red);
  mix(1, colour.green);
  mix(2, colour.blue);
}

void Canvas::fill(const Box& box, const Colour& colour, double opacity) {
  const Pixels area = pixels_of(box);
  for (int row = area.bottom; row < area.top; ++row) {
    for (int column = area.left; column < area.right; ++column) {
      const double share = overlap(column, box.low.x, box.high.x) * overlap(row, box.low.y, box.high.y);
      blend(column, row, colour, share * opacity);
    }
  }
}

void Canvas::cover_segment(const Point& from, const Point& to, double width) {
  const double reach = 0.5 * width + 0.5;
  const Pixels area = pixels_of(box_around({from, to}, reach));
  for (int row = area.bottom; row < area.top; ++row) {
    for (int column = area.left; column < area.right; ++column) {
      const double distance = distance_to_segment({column + 0.5, row + 0.5}, from, to);
      const double covered = std::min({1.0, width, reach - distance});
      float& coverage = coverage_[index(column, row)];
      coverage = std::max(coverage, static_cast<float>(covered));
    }
  }
}

void Canvas::ink_covered(const Pixels& area, const Colour& colour) {
  for (int row = area.bottom; row < area.top; ++row) {
    for (int column = area.left; column < area.right; ++column) {
      float& coverage = coverage_[index(column, row)];
      if (coverage > 0.0F) blend(column, row, colour, coverage);
      coverage = 0.0F;
    }
  }
}

void Canvas::line(const std::vector<Point>& points, const Pen& pen) {
  if (points.empty()) return;
  for (const std::vector<Point>& stroke : dashes(points, pen.dash)) {
    if (stroke.size() == 1) cover_segment(stroke.front(), stroke.front(), pen.width);
    for (std::size_t i = 1; i < stroke.size(); ++i) cover_segment(stroke[i - 1], stroke[i], pen.width);
  }
  ink_covered(pixels_of(box_around(points, pen.width + 1.0)), pen.colour);
}

void Canvas::frame(const Box& box, const Pen& pen) {
  line({box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}, box.low}, pen);
}

void Canvas::circle(const Point& centre, double radius, const Pen& pen) {
  line(arc_points(centre, radius), pen);
}

void Canvas::disc(const Point& centre, double radius, const Colour& colour) {
  line({centre}, {colour, 2.0 * radius});
}

void Canvas::text(const Point& anchor, const std::string& text, const TextStyle& style) {
  const TextBitmap bitmap = text_bitmap(text, style.font);
  const double dx = shift(style.x, bitmap.width);
  const double dy = shift(style.y, bitmap.capital) - bitmap.baseline;
  const int left = static_cast<int>(std::lround(style.upward ? anchor.x - dy - bitmap.height : anchor.x + dx));
  const int bottom = static_cast<int>(std::lround(style.upward ? anchor.y + dx : anchor.y + dy));
  const int across = style.upward ? bitmap.height : bitmap.width;
  const int up = style.upward ? bitmap.width : bitmap.height;
  const Box ground{{static_cast<double>(left), static_cast<double>(bottom)},
                   {static_cast<double>(left + across), static_cast<double>(bottom + up)}};
  if (style.halo > 0.0) fill(ground, white, style.halo);
  const Pixels area = pixels_of(ground);
  for (int row = area.bottom; row < area.top; ++row) {
    for (int column = area.left; column < area.right; ++column) {
      const int u = style.upward ? row - bottom : column - left;
      const int v = style.upward ? left + across - 1 - column : row - bottom;
      const auto texel =
          static_cast<std::size_t>(v) * static_cast<std::size_t>(bitmap.width) + static_cast<std::size_t>(u);
      blend(column, row, style.colour, bitmap.coverage[texel] / 255.0);
    }
  }
}

Picture Canvas::picture() const {
  Picture picture{width_, height_, {}};
  picture.rgb.reserve(rgb_.size());
  for (const float value : rgb_) picture.rgb.push_back(static_cast<std::uint8_t>(std::lround(value)));
  return picture;
}

TextSize text_size(const std::string& text, const Font& font) {
  const TextBitmap bitmap = text_bitmap(text, font);
  return {static_cast<double>(bitmap.width), static_cast<double>(bitmap.capital)};
}

Font fitting(const std::string& text, Font font, double room) {
  const int smallest = font.size / 2;
  while (font.size > smallest && text_size(text, font).width > room) --font.size;
  return font;
}

}  // namespace lrcs
