#include "view/colour_bar.h"

#include <cmath>

#include "view/plot_header.h"

namespace lrcs {

void draw_viridis(Canvas& canvas, const Box& bar) {
  const double height = bar.high.y - bar.low.y, rows = std::floor(height);
  std::vector<Tile> tiles;
  for (double row = 0.0; row < rows; row += 1.0) {
    const double low = bar.low.y + height * row / rows, high = bar.low.y + height * (row + 1.0) / rows;
    tiles.push_back(
        {{{bar.low.x, low}, {bar.high.x, low}, {bar.high.x, high}, {bar.low.x, high}}, viridis((row + 0.5) / rows)});
  }
  canvas.tiles(tiles);
}

void draw_colour_bar(Canvas& canvas, const Box& bar, const Axis& axis) {
  constexpr double tick = 10.0, gap = 12.0;  // [pixel]
  const double height = bar.high.y - bar.low.y;
  draw_viridis(canvas, bar);
  canvas.frame(bar, {ink, 2.0});
  for (std::size_t i = 0; i < axis.marks.size(); ++i) {
    const double y = bar.low.y + height * (axis.marks[i] - axis.low) / (axis.high - axis.low);
    canvas.line({{bar.high.x, y}, {bar.high.x + tick, y}}, {ink, 2.0});
    const double x = bar.high.x + tick + gap;
    canvas.text({x, y}, axis.labels[i],
                {.font = fitting(axis.labels[i], mark_font, canvas.width() - x - gap), .y = AlignY::middle});
  }
}

}  // namespace lrcs
