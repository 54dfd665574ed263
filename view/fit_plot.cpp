#include "view/fit_plot.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "view/incidence_family.h"
#include "view/marker.h"
#include "view/plot_file.h"

namespace lrcs {
namespace {

using Curves = std::vector<const FitCurve*>;

bool all_finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

void require_valid(const FitCurve& curve) {
  const std::size_t measured = curve.measured_theta_r_deg.size();
  const std::size_t fitted = curve.fitted_theta_r_deg.size();
  if (measured == 0 || fitted == 0) throw std::invalid_argument("a fit's curve needs measured and fitted points");
  if (curve.measured_f_r_per_sr.size() != measured || curve.residual.size() != measured ||
      curve.fitted_f_r_per_sr.size() != fitted)
    throw std::invalid_argument("a fit's curve needs as many angles as values and residuals");
  for (const auto* values :
       {&curve.measured_theta_r_deg, &curve.measured_f_r_per_sr, &curve.fitted_theta_r_deg, &curve.fitted_f_r_per_sr})
    if (!all_finite(*values)) throw std::invalid_argument("a fit's curve needs finite numbers");
  const auto negative = [](double f_r) { return f_r < 0.0; };
  if (!std::isfinite(curve.theta_i_deg) ||
      std::any_of(curve.fitted_f_r_per_sr.begin(), curve.fitted_f_r_per_sr.end(), negative) ||
      !std::is_sorted(curve.fitted_theta_r_deg.begin(), curve.fitted_theta_r_deg.end()))
    throw std::invalid_argument("a fit's curve needs rising angles, a finite theta_i and no negative fitted value");
}

Curves by_rising_incidence(const std::vector<FitCurve>& all) {
  Curves rising;
  for (const FitCurve& curve : all) rising.push_back(&curve);
  std::stable_sort(rising.begin(), rising.end(),
                   [](const auto* a, const auto* b) { return a->theta_i_deg < b->theta_i_deg; });
  return rising;
}

std::size_t most_points(const Curves& curves) {
  std::size_t points = 0;
  for (const FitCurve* curve : curves) points = std::max(points, curve->measured_theta_r_deg.size());
  return points;
}

// So many symbols that they would hide a line behind them.
bool is_dense(const Curves& curves) {
  return most_points(curves) > 90;
}

// Dense symbols have no rim: it would paint over their neighbours.
Marker marker_of(std::size_t k, const Curves& curves) {
  Marker marker{marker_shape(k), curve_colour(k), most_points(curves) > 60 ? 7.0 : 9.0};
  if (is_dense(curves)) marker = {marker.shape, marker.colour, 4.5, 0.0};
  return marker;
}

Marker legend_marker(std::size_t k) {
  return {marker_shape(k), curve_colour(k), 8.0};
}

Pen fit_pen(std::size_t k) {
  Pen pen = curve_pen(k);
  pen.width = 4.0;
  return pen;
}

Axis angle_axis(const Curves& curves) {
  Extent extent;
  for (const FitCurve* curve : curves)
    for (const auto* angles : {&curve->measured_theta_r_deg, &curve->fitted_theta_r_deg})
      for (const double angle : *angles) extent.take(angle);
  const double room = 0.02 * (extent.high - extent.low);  // for the symbols of the last points
  return scattering_axis({extent.low - room, extent.high + room}, signed_scattering_angle);
}

Axis value_axis(const Curves& curves, ValueScale scale) {
  Extent all, positive;
  for (const FitCurve* curve : curves)
    for (const auto* values : {&curve->measured_f_r_per_sr, &curve->fitted_f_r_per_sr})
      for (const double f_r : *values) {
        all.take(f_r);
        if (f_r > 0.0) positive.take(f_r);
      }
  return f_r_axis(all, positive, scale);
}

struct ResidualText {
  std::string axis, note;
  double least;  // less is rounding
};

ResidualText text_of(ResidualKind kind) {
  if (kind == ResidualKind::logarithm) return {"ln(fit/measured)", "residual of ln f_r", 1e-4};
  return {"residual [%]", "residual of f_r cos theta_r, in percent of the largest measured one", 0.01};
}

Axis residual_axis(const Curves& curves, const ResidualText& text) {
  constexpr double room = 1.08;  // for the symbols of the largest
  double largest = text.least;
  for (const FitCurve* curve : curves)
    for (const double residual : curve->residual)
      if (std::isfinite(residual)) largest = std::max(largest, std::abs(residual));
  return symmetric_axis(text.axis, room * largest);
}

std::string note_of(const FitPicture& picture, const Curves& curves, const Axis& values) {
  std::size_t below = 0;
  for (const FitCurve* curve : curves)
    for (const double f_r : curve->measured_f_r_per_sr) below += f_r < values.low ? 1 : 0;
  std::string note = "symbols: measured; lines: fitted";
  if (below > 0) note += "; " + std::to_string(below) + " measured points lie below the axis";
  return picture.note + "\n" + note;
}

std::vector<LegendEntry> legend_of(const Curves& curves) {
  std::vector<LegendEntry> legend;
  for (std::size_t k = 0; k < curves.size(); ++k)
    legend.push_back({incidence_label(curves[k]->theta_i_deg), fit_pen(k), legend_marker(k)});
  return legend;
}

// Two boxes one above the other, as wide as the wider labels allow.
struct Panels {
  Box values, residuals;
};

Panels panels_of(const Canvas& canvas, double top, const Axis& x, const Axis& values, const Axis& residuals) {
  constexpr double residual_height = 260.0, between = 70.0;  // [pixel]
  const Box a = room_for_frame(canvas, top, x, values);
  const Box b = room_for_frame(canvas, top, x, residuals);
  const double left = std::max(a.low.x, b.low.x);
  const double middle = a.low.y + residual_height;
  return {{{left, middle + between}, a.high}, {{left, a.low.y}, {a.high.x, middle}}};
}

Axis without_labels(Axis axis) {
  axis.title.clear();
  axis.labels.assign(axis.labels.size(), "");
  return axis;
}

std::vector<Point> points_on(const CartesianFrame& frame, const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (y[i] >= frame.y.low) points.push_back(frame.at(x[i], y[i]));
  return points;
}

// The first of those that lie in the same square: symbols nearer than that cannot be told apart.
std::vector<Point> thinned(const std::vector<Point>& points) {
  constexpr double square = 2.0;  // [pixel]
  std::set<std::pair<int, int>> taken;
  std::vector<Point> kept;
  for (const Point& point : points)
    if (taken.emplace(static_cast<int>(point.x / square), static_cast<int>(point.y / square)).second)
      kept.push_back(point);
  return kept;
}

void draw_symbols(Canvas& canvas, const CartesianFrame& frame, const Curves& curves,
                  const std::vector<double> FitCurve::*values) {
  for (std::size_t k = curves.size(); k-- > 0;) {
    const auto points = points_on(frame, curves[k]->measured_theta_r_deg, curves[k]->*values);
    draw_markers(canvas, thinned(points), marker_of(k, curves));
  }
}

void draw_lines(Canvas& canvas, const CartesianFrame& frame, const Curves& curves, double rim) {
  canvas.clip(frame.box);
  for (std::size_t k = curves.size(); k-- > 0;) {
    const Pen pen = fit_pen(k);
    const auto draw = [&](const Pen& with) {
      draw_broken_line(canvas, frame, curves[k]->fitted_theta_r_deg, curves[k]->fitted_f_r_per_sr, with);
    };
    if (rim > 0.0) draw({white, pen.width + 2.0 * rim});
    draw(pen);
  }
  canvas.no_clip();
}

// Symbols lie over the lines; where they would hide them, the lines lie over them, with a white rim.
void draw_values(Canvas& canvas, const Box& box, const Axis& x, const Axis& y, const Curves& curves) {
  const CartesianFrame frame = draw_cartesian_frame(canvas, box, without_labels(x), y);
  if (!is_dense(curves)) draw_lines(canvas, frame, curves, 0.0);
  draw_outline(canvas, frame);
  draw_symbols(canvas, frame, curves, &FitCurve::measured_f_r_per_sr);
  if (is_dense(curves)) draw_lines(canvas, frame, curves, 1.5);
}

void draw_residuals(Canvas& canvas, const Box& box, const Axis& x, const Axis& y, const std::string& note,
                    const Curves& curves) {
  constexpr double above = 14.0;  // the frame [pixel]
  canvas.text({box.low.x, box.high.y + above}, note, {.font = note_font});
  const CartesianFrame frame = draw_cartesian_frame(canvas, box, x, y);
  const auto draw_zero = [&] { canvas.line({frame.at(x.low, 0.0), frame.at(x.high, 0.0)}, {ink, 3.0}); };
  if (!is_dense(curves)) draw_zero();
  draw_symbols(canvas, frame, curves, &FitCurve::residual);
  if (is_dense(curves)) draw_zero();
}

}  // namespace

void draw_fit_plot(const std::filesystem::path& file, const FitPicture& picture) {
  if (picture.curves.empty() || picture.curves.size() > most_incidences_of_a_fit)
    throw std::invalid_argument("a plot of a fit needs one to eight curves");
  for (const FitCurve& curve : picture.curves) require_valid(curve);
  const Curves curves = by_rising_incidence(picture.curves);
  const Axis x = angle_axis(curves);
  const Axis values = value_axis(curves, picture.scale);
  const ResidualText text = text_of(picture.residuals);
  const Axis residuals = residual_axis(curves, text);
  Canvas canvas = plot_canvas(file, 1600, 1300);
  constexpr double between = 14.0;  // legend and frame [pixel]
  const double top =
      draw_header(canvas, {picture.title, note_of(picture, curves, values), legend_of(curves)}) - between;
  const Panels panels = panels_of(canvas, top, x, values, residuals);
  draw_values(canvas, panels.values, x, values, curves);
  draw_residuals(canvas, panels.residuals, x, residuals, text.note, curves);
  write_plot(file, canvas);
}

}  // namespace lrcs
