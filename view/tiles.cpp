#include "view/tiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "view/canvas.h"
#include "view/extent.h"

namespace lrcs {
namespace {

constexpr int fine = 4;  // points a pixel, each way

bool is_finite(const Tile& tile) {
  return std::all_of(tile.outline.begin(), tile.outline.end(),
                     [](const Point& p) { return std::isfinite(p.x) && std::isfinite(p.y); });
}

// Pixels: columns and rows [low, high).
struct Area {
  int left, bottom, right, top;
};

Area area_of(const std::vector<Tile>& tiles, const Picture& picture, const Box& clip) {
  Extent x, y;
  for (const Tile& tile : tiles) {
    if (!is_finite(tile)) continue;
    for (const Point& corner : tile.outline) {
      x.take(corner.x);
      y.take(corner.y);
    }
  }
  if (x.empty()) return {0, 0, 0, 0};
  const auto within = [](double place, double low, double high, int size) {
    return static_cast<int>(std::clamp(std::clamp(place, low, high), 0.0, static_cast<double>(size)));
  };
  return {within(std::floor(x.low), clip.low.x, clip.high.x, picture.width),
          within(std::floor(y.low), clip.low.y, clip.high.y, picture.height),
          within(std::ceil(x.high), clip.low.x, clip.high.x, picture.width),
          within(std::ceil(y.high), clip.low.y, clip.high.y, picture.height)};
}

// A part of a picture, `fine` times as fine.
class FineSheet {
 public:
  FineSheet(const Picture& picture, const Area& area)
      : area_(area), columns_(fine * (area.right - area.left)), rows_(fine * (area.top - area.bottom)) {
    points_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column) {
        const std::uint8_t* pixel = picture.rgb.data() + offset(picture, column / fine, row / fine);
        at(column, row) = {pixel[0], pixel[1], pixel[2]};
      }
  }

  void paint(const Tile& tile) {
    Extent height;
    for (const Point& corner : tile.outline) height.take(corner.y);
    const Rgb rgb = rgb_of(tile.colour);
    const int last = place(height.high, area_.bottom, rows_);
    for (int row = place(height.low, area_.bottom, rows_); row < last; ++row) paint_row(tile.outline, row, rgb);
  }

  void shrink_into(Picture& picture) const {
    for (int row = 0; row < rows_ / fine; ++row)
      for (int column = 0; column < columns_ / fine; ++column) {
        const Rgb mean = mean_of_pixel(column, row);
        std::copy(mean.begin(), mean.end(), picture.rgb.data() + offset(picture, column, row));
      }
  }

 private:
  // The first point whose middle does not lie before a height or column on the canvas, within [0, points].
  static int place(double on_canvas, int start, int points) {
    return static_cast<int>(std::clamp(std::ceil(fine * (on_canvas - start) - 0.5), 0.0, static_cast<double>(points)));
  }

  [[nodiscard]] std::size_t offset(const Picture& picture, int column, int row) const {
    return 3 * (static_cast<std::size_t>(area_.bottom + row) * static_cast<std::size_t>(picture.width) +
                static_cast<std::size_t>(area_.left + column));
  }

  Rgb& at(int column, int row) { return points_[static_cast<std::size_t>(row) * columns_ + column]; }
  [[nodiscard]] const Rgb& at(int column, int row) const {
    return points_[static_cast<std::size_t>(row) * columns_ + column];
  }

  // An edge is always walked from its lower end, so that both tiles beside it find the same crossing.
  void paint_row(const std::vector<Point>& outline, int row, const Rgb& rgb) {
    const double y = area_.bottom + (row + 0.5) / fine;
    crossings_.clear();
    for (std::size_t i = 0; i < outline.size(); ++i) {
      Point low = outline[i], high = outline[(i + 1) % outline.size()];
      if (low.y > high.y) std::swap(low, high);
      if (low.y <= y && y < high.y) crossings_.push_back(low.x + (high.x - low.x) * ((y - low.y) / (high.y - low.y)));
    }
    std::sort(crossings_.begin(), crossings_.end());
    for (std::size_t i = 0; i + 1 < crossings_.size(); i += 2) {
      const int last = place(crossings_[i + 1], area_.left, columns_);
      for (int column = place(crossings_[i], area_.left, columns_); column < last; ++column) at(column, row) = rgb;
    }
  }

  [[nodiscard]] Rgb mean_of_pixel(int column, int row) const {
    std::array<int, 3> sum{};
    for (int dy = 0; dy < fine; ++dy)
      for (int dx = 0; dx < fine; ++dx)
        for (std::size_t channel = 0; channel < 3; ++channel)
          sum[channel] += at(fine * column + dx, fine * row + dy)[channel];
    constexpr int count = fine * fine;
    Rgb mean{};
    for (std::size_t channel = 0; channel < 3; ++channel)
      mean[channel] = static_cast<std::uint8_t>((sum[channel] + count / 2) / count);
    return mean;
  }

  Area area_;
  int columns_, rows_;
  std::vector<Rgb> points_;
  std::vector<double> crossings_;
};

}  // namespace

void paint_tiles(Picture& picture, const Box& clip, const std::vector<Tile>& tiles) {
  const Area area = area_of(tiles, picture, clip);
  if (area.left >= area.right || area.bottom >= area.top) return;
  FineSheet sheet(picture, area);
  for (const Tile& tile : tiles)
    if (is_finite(tile)) sheet.paint(tile);
  sheet.shrink_into(picture);
}

}  // namespace lrcs
