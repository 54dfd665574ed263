#include "view/cut_drawing.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "view/ticks.h"

namespace lrcs {
namespace {

std::string note_on(const DecibelRange& range) {
  if (range.all_zero) return "LRCS is 0 m² in every direction";
  if (!range.floor_used) return "";
  return "No line where LRCS is 0 or below " + tick_label(range.low, range.step) + " dBsm";
}

void add_bent(std::vector<Point>& points, const CutPoint& from, const CutPoint& to, const CutMap& map) {
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(to.angle_deg - from.angle_deg))));
  for (int step = 1; step <= steps; ++step) {
    const double share = static_cast<double>(step) / steps;
    points.push_back(map({std::lerp(from.angle_deg, to.angle_deg, share), std::lerp(from.dbsm, to.dbsm, share)}));
  }
}

void draw_stroke(Canvas& canvas, const std::vector<CutPoint>& stroke, const CutMap& map, bool straight,
                 const Pen& pen) {
  std::vector<Point> points{map(stroke.front())};
  for (std::size_t i = 1; i < stroke.size(); ++i) {
    if (straight) points.push_back(map(stroke[i]));
    if (!straight) add_bent(points, stroke[i - 1], stroke[i], map);
  }
  canvas.line(points, pen);
}

void draw_dots(Canvas& canvas, const std::vector<CutPoint>& cut, double floor, const CutMap& map, const Pen& pen) {
  constexpr std::size_t few = 60;
  if (cut.size() > few) return;
  for (const CutPoint& point : cut) {
    if (point.dbsm >= floor) canvas.disc(map(point), 1.6 * pen.width, pen.colour);
  }
}

}  // namespace

CutDrawing cut_drawing(const std::vector<Curve>& curves, const PlotText& text, double least_span) {
  if (curves.empty()) throw std::invalid_argument("a plot needs at least one curve");
  CutDrawing drawing;
  for (const Curve& curve : curves) drawing.cuts.push_back(cut_points(curve));
  drawing.range = decibel_range(drawing.cuts, least_span);
  drawing.header = {text.title, note_on(drawing.range), {}};
  for (std::size_t i = 0; curves.size() > 1 && i < curves.size(); ++i) {
    drawing.header.legend.push_back({curves[i].label, curve_pen(i)});
  }
  return drawing;
}

void draw_curves(Canvas& canvas, const CutDrawing& drawing, const CutMap& map, bool straight) {
  for (std::size_t i = drawing.cuts.size(); i-- > 0;) {
    const std::vector<CutPoint>& cut = drawing.cuts[i];
    const Pen pen = curve_pen(i);
    for (const auto& stroke : strokes_above(cut, drawing.range.low)) draw_stroke(canvas, stroke, map, straight, pen);
    draw_dots(canvas, cut, drawing.range.low, map, pen);
  }
}

void draw_floor_ticks(Canvas& canvas, const CutDrawing& drawing, const CutMap& map) {
  const double low = drawing.range.low;
  const double top = low + 0.02 * (drawing.range.high - low);
  for (std::size_t i = drawing.cuts.size(); i-- > 0;) {
    std::vector<std::vector<Point>> ticks;
    for (const CutPoint& point : drawing.cuts[i]) {
      if (point.dbsm < low) ticks.push_back({map({point.angle_deg, low}), map({point.angle_deg, top})});
    }
    canvas.strokes(ticks, {curve_colour(i), 3.0});
  }
}

}  // namespace lrcs
