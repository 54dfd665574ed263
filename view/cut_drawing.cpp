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
  return "No line where LRCS is 0 or below " + floor_label(range) + " dBsm";
}

bool has_band(const CutPoint& point) {
  return point.low_dbsm < point.high_dbsm;
}

bool has_bands(const CutDrawing& drawing) {
  return std::any_of(drawing.cuts.begin(), drawing.cuts.end(),
                     [](const auto& cut) { return std::any_of(cut.begin(), cut.end(), has_band); });
}

// How a curve is drawn: all are thin where there are bands, for the bands to show beside them.
Pen pen_of(const CutDrawing& drawing, std::size_t curve) {
  constexpr double thin = 2.0;  // [pixel]
  Pen pen = curve_pen(curve);
  if (has_bands(drawing)) pen.width = thin;
  return pen;
}

// A band that would not show is taken away. `least`: width of one that does [dB].
void keep_wide_band(std::vector<CutPoint>& cut, double least) {
  const auto is_wide = [&](const CutPoint& point) {
    return has_band(point) && point.high_dbsm - point.low_dbsm > least;
  };
  if (std::any_of(cut.begin(), cut.end(), is_wide)) return;
  for (CutPoint& point : cut) point.low_dbsm = point.high_dbsm = point.dbsm;
}

void add_bent(std::vector<Point>& points, const CutPoint& from, const CutPoint& to, const CutMap& map) {
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(to.angle_deg - from.angle_deg))));
  for (int step = 1; step <= steps; ++step) {
    const double share = static_cast<double>(step) / steps;
    points.push_back(map({std::lerp(from.angle_deg, to.angle_deg, share), std::lerp(from.dbsm, to.dbsm, share)}));
  }
}

// Through the points in order, bent where the map bends straight lines.
std::vector<Point> drawn_points(const std::vector<CutPoint>& stroke, const CutMap& map, bool straight) {
  std::vector<Point> points{map(stroke.front())};
  for (std::size_t i = 1; i < stroke.size(); ++i) {
    if (straight) points.push_back(map(stroke[i]));
    if (!straight) add_bent(points, stroke[i - 1], stroke[i], map);
  }
  return points;
}

// Along the upper edge and back along the lower one; a direction by itself has an upright line.
void draw_band(Canvas& canvas, const std::vector<CutPoint>& high, std::vector<CutPoint> low, const CutMap& map,
               bool straight, const Colour& colour) {
  constexpr double opacity = 0.4;
  if (high.size() == 1) canvas.line({map(high.front()), map(low.front())}, {colour, 2.0});
  if (high.size() < 2) return;
  std::reverse(low.begin(), low.end());
  std::vector<Point> outline = drawn_points(high, map, straight);
  const std::vector<Point> back = drawn_points(low, map, straight);
  outline.insert(outline.end(), back.begin(), back.end());
  canvas.area(outline, colour, opacity);
}

void draw_dots(Canvas& canvas, const std::vector<CutPoint>& cut, double floor, const CutMap& map, const Pen& pen) {
  constexpr std::size_t few = 60;
  if (cut.size() > few) return;
  for (const CutPoint& point : cut) {
    if (point.dbsm >= floor) canvas.disc(map(point), 1.6 * pen.width, pen.colour);
  }
}

}  // namespace

CutDrawing cut_drawing(const std::vector<Curve>& curves, const PlotText& text, double least_span, double length) {
  constexpr double least_band = 4.0;  // that shows beside a thin line [pixel]
  if (curves.empty()) throw std::invalid_argument("a plot needs at least one curve");
  CutDrawing drawing;
  for (const Curve& curve : curves) drawing.cuts.push_back(cut_points(curve, text.angle != CutAngle::other));
  drawing.range = decibel_range(drawing.cuts, least_span, text.floor_dbsm);
  for (std::size_t i = 0; i < drawing.cuts.size(); ++i)
    keep_wide_band(drawing.cuts[i], least_band * (drawing.range.high - drawing.range.low) / length);
  drawing.header = {text.title, note_on(drawing.range), {}};
  if (has_bands(drawing)) drawing.header.note += "\nBand: bound (LRCS − bound to LRCS + bound)";
  for (std::size_t i = 0; curves.size() > 1 && i < curves.size(); ++i) {
    drawing.header.legend.push_back({curves[i].label, pen_of(drawing, i)});
  }
  return drawing;
}

void draw_bands(Canvas& canvas, const CutDrawing& drawing, const CutMap& map, bool straight) {
  const double floor = drawing.range.low;
  for (std::size_t i = drawing.cuts.size(); i-- > 0;) {
    if (std::none_of(drawing.cuts[i].begin(), drawing.cuts[i].end(), has_band)) continue;
    std::vector<CutPoint> high, low;
    const auto finish = [&] {
      draw_band(canvas, high, low, map, straight, curve_colour(i));
      high.clear(), low.clear();
    };
    for (const CutPoint& point : drawing.cuts[i]) {
      if (!std::isfinite(point.high_dbsm)) finish();
      if (!std::isfinite(point.high_dbsm)) continue;
      high.push_back({point.angle_deg, std::clamp(point.high_dbsm, floor, drawing.range.high)});
      low.push_back({point.angle_deg, std::clamp(point.low_dbsm, floor, drawing.range.high)});
    }
    finish();
  }
}

void draw_curves(Canvas& canvas, const CutDrawing& drawing, const CutMap& map, bool straight) {
  for (std::size_t i = drawing.cuts.size(); i-- > 0;) {
    const std::vector<CutPoint>& cut = drawing.cuts[i];
    const Pen pen = pen_of(drawing, i);
    for (const auto& stroke : strokes_above(cut, drawing.range.low))
      canvas.line(drawn_points(stroke, map, straight), pen);
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
