#include "bench/work_precision_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "bench/decades.h"
#include "bench/method.h"
#include "view/cartesian_frame.h"
#include "view/plot_header.h"

namespace lrcs {
namespace {

constexpr double milli = 1e3;  // ms a second

double error_of(const Summary& s) {
  return s.error.sigma_wu;
}

bool is_exact(const Summary& s) {
  return s.family == exact_family || s.family == exact_to_sigma_family;
}

struct PlotCurve {
  std::string family;
  std::vector<Summary> points;
};

std::vector<PlotCurve> curves_of(const std::vector<Summary>& of_target) {
  std::vector<PlotCurve> curves;
  for (const Summary& s : of_target) {
    if (is_exact(s) || error_of(s) <= 0.0) continue;
    if (curves.empty() || curves.back().family != s.family) curves.push_back({s.family, {}});
    curves.back().points.push_back(s);
  }
  return curves;
}

void draw_curve(Canvas& canvas, const CartesianFrame& frame, const PlotCurve& curve, const Pen& pen) {
  constexpr double radius = 11.0;  // [pixel]
  std::vector<Point> line;
  for (const Summary& s : curve.points) line.push_back(frame.at(milli * s.seconds, error_of(s)));
  canvas.line(line, pen);
  for (const Point& p : line) canvas.disc(p, radius, pen.colour);
}

// What labels keep clear of: places along the curves, and labels that are there already.
std::vector<Point> places_along(const CartesianFrame& frame, const std::vector<PlotCurve>& curves) {
  constexpr int parts = 16;
  std::vector<Point> places;
  for (const PlotCurve& curve : curves)
    for (std::size_t k = 0; k < curve.points.size(); ++k) {
      const auto at = [&](std::size_t point) {
        return frame.at(milli * curve.points[point].seconds, error_of(curve.points[point]));
      };
      const Point from = at(k), to = at(std::min(k + 1, curve.points.size() - 1));
      for (int part = 0; part < parts; ++part)
        places.push_back({from.x + (to.x - from.x) * part / parts, from.y + (to.y - from.y) * part / parts});
    }
  return places;
}

// Beside a point, where most is clear: to the left or the right, above or below.
void label_point(Canvas& canvas, const Point& p, const std::string& mark, const Colour& colour,
                 std::vector<Point>& taken) {
  constexpr double aside = 16.0, letter = 17.0, height = 30.0;  // [pixel]
  const double width = letter * static_cast<double>(mark.size());
  Point best{};
  double clearest = -1.0;
  for (const double across : {1.0, -1.0})
    for (const double up : {1.0, -1.0}) {
      const Point middle{p.x + across * (aside + 0.5 * width), p.y + up * (aside + 0.5 * height)};
      double clear = std::numeric_limits<double>::infinity();
      for (const Point& other : taken)
        clear = std::min(clear, std::hypot(std::max(0.0, std::abs(other.x - middle.x) - 0.5 * width),
                                           std::max(0.0, std::abs(other.y - middle.y) - 0.5 * height)));
      if (clear <= clearest) continue;
      clearest = clear;
      best = middle;
    }
  canvas.text(best, mark, {.font = {30, false}, .colour = colour, .x = AlignX::centre, .y = AlignY::middle});
  for (const double part : {-0.5, 0.0, 0.5}) taken.push_back({best.x + part * width, best.y});
}

void draw_exact(Canvas& canvas, const CartesianFrame& frame, const Summary& exact, const Pen& pen) {
  constexpr double barb = 22.0;  // [pixel]
  const Point foot = frame.at(milli * exact.seconds, frame.y.low);
  const Point top = frame.at(milli * exact.seconds, frame.y.high);
  canvas.line({foot, top}, pen);
  canvas.line({{foot.x - 0.6 * barb, foot.y + barb}, foot, {foot.x + 0.6 * barb, foot.y + barb}}, pen);
}

}  // namespace

void draw_work_precision(const std::filesystem::path& png, const std::vector<Summary>& of_target,
                         std::size_t directions) {
  const auto curves = curves_of(of_target);
  const auto exact = std::find_if(of_target.begin(), of_target.end(), is_exact);
  assert(!curves.empty() && exact != of_target.end());
  const Pen exact_pen{ink, 6.0};
  std::vector<double> times{milli * exact->seconds}, errors;
  PlotHeader header{
      exact->target,
      fmt::format("{} facets, monostatic, metal-skin-5p, one thread, {} directions", exact->facets, directions),
      {{"exact", exact_pen}}};
  for (std::size_t k = 0; k < curves.size(); ++k) {
    header.legend.push_back({curves[k].family, curve_pen(k)});
    for (const Summary& s : curves[k].points) {
      times.push_back(milli * s.seconds);
      errors.push_back(error_of(s));
    }
  }
  Canvas canvas(1600, 1200);
  const double top = draw_header(canvas, header);
  const CartesianFrame frame = draw_cartesian_frame(canvas, top, decades("median time a direction [ms]", times),
                                                    decades("relative error of sigma, root mean square", errors));
  rule_finely(canvas, frame);
  draw_exact(canvas, frame, *exact, exact_pen);
  for (std::size_t k = curves.size(); k-- > 0;) draw_curve(canvas, frame, curves[k], curve_pen(k));
  std::vector<Point> taken = places_along(frame, curves);
  for (std::size_t k = 0; k < curves.size(); ++k)
    for (const Summary* end : {&curves[k].points.front(), &curves[k].points.back()})
      if (end == &curves[k].points.front() || curves[k].points.size() > 1)
        label_point(canvas, frame.at(milli * end->seconds, error_of(*end)), end->mark, curve_pen(k).colour, taken);
  draw_outline(canvas, frame);
  write_png(png, canvas.picture());
}

}  // namespace lrcs
