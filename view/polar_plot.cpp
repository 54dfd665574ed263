#include <algorithm>
#include <cmath>

#include "base/vec3.h"
#include "view/cut_drawing.h"
#include "view/plot_file.h"
#include "view/sweep_plot.h"
#include "view/ticks.h"

namespace lrcs {
namespace {

// The ruled disc of a polar plot.
struct PolarFrame {
  Point centre;
  double radius = 0.0;   // of the outermost ring [pixel]
  double zero_at = 0.0;  // where 0 deg points, counter-clockwise from the right [deg]
  DecibelRange range;

  [[nodiscard]] Point at(const CutPoint& point) const {
    return along(point.angle_deg, radius * (point.dbsm - range.low) / (range.high - range.low));
  }
  [[nodiscard]] Point along(double angle_deg, double length) const {
    const double angle = (angle_deg + zero_at) * degree;
    return {centre.x + length * std::cos(angle), centre.y + length * std::sin(angle)};
  }
};

std::string spoke_label(double angle_deg, CutAngle angle) {
  const bool signed_angle = angle == CutAngle::elevation && angle_deg > 180.0;
  std::string degrees = tick_label(signed_angle ? angle_deg - 360.0 : angle_deg, 1.0) + "°";
  if (angle == CutAngle::other || angle_deg != 0.0) return degrees;
  return degrees + " nose";
}

// Texts beside the disc stand clear of it on all sides.
AlignX side(double cosine) {
  if (std::abs(cosine) < 0.1) return AlignX::centre;
  return cosine > 0.0 ? AlignX::left : AlignX::right;
}

void draw_spokes(Canvas& canvas, const PolarFrame& frame, CutAngle angle) {
  constexpr double spacing = 30.0;  // [deg]
  for (double spoke = 0.0; spoke < 360.0; spoke += spacing) {
    canvas.line({frame.centre, frame.along(spoke, frame.radius)}, {grid_grey, 2.0});
    const Point end = frame.along(spoke, frame.radius + 20.0);
    const double cosine = (end.x - frame.centre.x) / (frame.radius + 20.0);
    const double sine = (end.y - frame.centre.y) / (frame.radius + 20.0);
    const double half_capital = 0.5 * text_size("0", mark_font).height;
    canvas.text({end.x, end.y + half_capital * sine}, spoke_label(spoke, angle),
                {.font = mark_font, .x = side(cosine), .y = AlignY::middle});
  }
}

void draw_rings(Canvas& canvas, const PolarFrame& frame) {
  for (const double ring : multiples(frame.range.low, frame.range.high, frame.range.step)) {
    const double radius = frame.radius * (ring - frame.range.low) / (frame.range.high - frame.range.low);
    const bool outermost = ring + 0.5 * frame.range.step > frame.range.high;
    if (radius > 0.0) canvas.circle(frame.centre, radius, outermost ? Pen{ink, 3.0} : Pen{grid_grey, 2.0});
  }
}

bool no_curve_near(const CutDrawing& drawing, double angle_deg) {
  constexpr double near = 15.0;  // [deg]
  for (const auto& cut : drawing.cuts) {
    for (const CutPoint& point : cut) {
      if (std::abs(std::remainder(point.angle_deg - angle_deg, 360.0)) < near) return false;
    }
  }
  return true;
}

// Between two spokes, where there is no curve if such a place is; else over the curves.
double ring_label_direction(const CutDrawing& drawing) {
  for (const double direction : {-45.0, 45.0, 135.0, -135.0}) {
    if (no_curve_near(drawing, direction)) return direction;
  }
  return -45.0;
}

void draw_ring_labels(Canvas& canvas, const PolarFrame& frame, double direction) {
  for (const double ring : multiples(frame.range.low, frame.range.high, frame.range.step)) {
    if (ring < frame.range.low + 0.5 * frame.range.step) continue;
    canvas.text(frame.at({direction, ring}), tick_label(ring, frame.range.step),
                {.font = note_font, .x = AlignX::centre, .y = AlignY::middle, .halo = 0.8});
  }
}

std::string frame_note(const PlotText& text) {
  if (text.angle == CutAngle::azimuth) return text.angle_axis + ", seen from above; ";
  if (text.angle == CutAngle::elevation) return text.angle_axis + ", seen from the right side; ";
  return text.angle_axis + "; ";
}

void draw_foot(Canvas& canvas, const DecibelRange& range, const PlotText& text) {
  const std::string foot = frame_note(text) + "rings: LRCS [dBsm], centre " + floor_label(range) + " dBsm";
  canvas.text({0.5 * canvas.width(), 30.0}, foot,
              {.font = fitting(foot, note_font, canvas.width() - 60.0), .x = AlignX::centre});
}

PolarFrame frame_below(double top, const Canvas& canvas, const DecibelRange& range, CutAngle angle) {
  constexpr double foot = 90.0;     // [pixel]
  constexpr double above = 64.0;    // for labels over and under the disc [pixel]
  constexpr double beside = 120.0;  // for labels to its left and right [pixel]
  const double radius = std::min(0.5 * (top - foot) - above, 0.5 * canvas.width() - beside);
  const double nose_beside = angle == CutAngle::azimuth ? 0.0 : 40.0;  // "0° nose" stands to the right
  const double fitted = radius - nose_beside;
  return {
      {0.5 * canvas.width() - nose_beside, 0.5 * (top + foot)}, fitted, angle == CutAngle::azimuth ? 90.0 : 0.0, range};
}

}  // namespace

void draw_polar_plot(Canvas& canvas, const std::vector<Curve>& curves, const PlotText& text) {
  constexpr double least_span = 20.0;  // [dB]
  const CutDrawing drawing = cut_drawing(curves, text, least_span, 0.35 * std::min(canvas.width(), canvas.height()));
  const double top = draw_header(canvas, drawing.header);
  const PolarFrame frame = frame_below(top, canvas, drawing.range, text.angle);
  const auto map = [&](const CutPoint& point) { return frame.at(point); };
  draw_spokes(canvas, frame, text.angle);
  draw_rings(canvas, frame);
  draw_bands(canvas, drawing, map, false);
  draw_curves(canvas, drawing, map, false);
  draw_ring_labels(canvas, frame, ring_label_direction(drawing));
  draw_foot(canvas, drawing.range, text);
}

void draw_polar_plot(const std::filesystem::path& file, const std::vector<Curve>& curves, const PlotText& text) {
  Canvas canvas = plot_canvas(file, 1200, 1200);
  draw_polar_plot(canvas, curves, text);
  write_plot(file, canvas);
}

}  // namespace lrcs
