#include "view/map_plot.h"

#include <algorithm>

#include "view/extent.h"
#include "view/plot_file.h"
#include "view/plot_header.h"
#include "view/ticks.h"

namespace lrcs {
namespace {

Axis axis_of_cells(const std::string& title, const Extent& extent, int most) {
  const double step = angle_step(extent.high - extent.low, most);
  Axis axis{title, extent.low, extent.high, multiples(extent.low, extent.high, step), {}};
  for (const double mark : axis.marks) axis.labels.push_back(tick_label(mark, step));
  return axis;
}

// Cells lie over the grid: what is left of it are ticks outside.
void draw_outer_ticks(Canvas& canvas, const CartesianFrame& frame) {
  constexpr double length = 10.0;  // [pixel]
  const Point low = frame.box.low;
  for (const double mark : frame.x.marks) {
    const double x = frame.at(mark, frame.y.low).x;
    canvas.line({{x, low.y}, {x, low.y - length}}, {ink, 2.0});
  }
  for (const double mark : frame.y.marks) {
    const double y = frame.at(frame.x.low, mark).y;
    canvas.line({{low.x, y}, {low.x - length, y}}, {ink, 2.0});
  }
}

}  // namespace

CartesianFrame draw_map_plot(Canvas& canvas, const DirectionMap& map, const MapText& text) {
  const DecibelRange range = map_range(map, text.floor_dbsm);
  const double top = draw_header(canvas, {text.title, map_note(map, range), {}});
  Extent across, up;
  for (const MapCell& cell : map_cells(map)) {
    across.take(cell.west), across.take(cell.east);
    up.take(cell.south), up.take(cell.north);
  }
  constexpr double label_room = 95.0, beside = 150.0;  // [pixel]
  const int most = std::clamp(static_cast<int>((canvas.width() - map_bar_room - beside) / label_room), 2, 12);
  const Axis x = axis_of_cells("azimuth [deg]", across, most), y = axis_of_cells("elevation [deg]", up, 7);
  Box box = room_for_frame(canvas, top, x, y);
  box.high.x = canvas.width() - map_bar_room;
  CartesianFrame frame = draw_cartesian_frame(canvas, box, x, y);
  std::vector<Tile> tiles;
  for (const MapCell& cell : map_cells(map))
    tiles.push_back({{frame.at(cell.west, cell.south), frame.at(cell.east, cell.south), frame.at(cell.east, cell.north),
                      frame.at(cell.west, cell.north)},
                     map_colour(range, cell.sigma_m2)});
  canvas.tiles(tiles);
  draw_outline(canvas, frame);
  draw_outer_ticks(canvas, frame);
  draw_map_bar(canvas, box.low.y, box.high.y, range);
  return frame;
}

void draw_map_plot(const std::filesystem::path& file, const DirectionMap& map, const MapText& text) {
  Canvas canvas = plot_canvas(file, 1600, 1000);
  draw_map_plot(canvas, map, text);
  write_plot(file, canvas);
}

}  // namespace lrcs
