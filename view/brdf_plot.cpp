#include "view/brdf_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "view/cartesian_frame.h"
#include "view/plot_header.h"
#include "view/ticks.h"

namespace lrcs {
namespace {

struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void take(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] bool empty() const { return low > high; }
};

void require_valid(const std::vector<BrdfCurve>& curves) {
  if (curves.empty()) throw std::invalid_argument("a plot needs at least one curve");
  for (const BrdfCurve& curve : curves) {
    if (curve.theta_r_deg.size() != curve.f_r_per_sr.size()) {
      throw std::invalid_argument("a BRDF curve needs as many angles as values");
    }
    const auto finite = [](double angle) { return std::isfinite(angle); };
    const auto negative = [](double f_r) { return f_r < 0.0; };
    if (!std::all_of(curve.theta_r_deg.begin(), curve.theta_r_deg.end(), finite) ||
        std::any_of(curve.f_r_per_sr.begin(), curve.f_r_per_sr.end(), negative)) {
      throw std::invalid_argument("a BRDF curve needs finite angles and no negative value");
    }
  }
}

Axis angle_axis(const std::vector<BrdfCurve>& curves) {
  Extent extent;
  for (const BrdfCurve& curve : curves) {
    for (const double angle : curve.theta_r_deg) extent.take(angle);
  }
  if (extent.empty()) extent.take(0.0);
  if (extent.low == extent.high) extent = {extent.low - 5.0, extent.high + 5.0};
  const double step = angle_step(extent.high - extent.low, 12);
  // Data that end just short of a mark (89 deg) get an axis that ends on it.
  constexpr double short_of = 0.1;  // [step]
  const double last = step * std::floor(extent.high / step + short_of);
  const double first = step * std::ceil(extent.low / step - short_of);
  Axis axis{"scattering angle [deg]", std::min(extent.low, first), std::max(extent.high, last), {}, {}, false};
  axis.marks = multiples(axis.low, axis.high, step);
  for (const double mark : axis.marks) axis.labels.push_back(tick_label(mark, step));
  return axis;
}

Axis linear_axis(const std::string& title, double highest) {
  const double step = nice_step(highest, 6);
  Axis axis{title, 0.0, step * std::ceil(highest / step), {}, {}, false};
  axis.marks = multiples(axis.low, axis.high, step);
  for (const double mark : axis.marks) axis.labels.push_back(tick_label(mark, step));
  return axis;
}

std::string decade_label(int exponent) {
  if (exponent >= -3 && exponent <= 3) return number_label(std::pow(10.0, exponent), 4);
  return "1e" + number_label(exponent, 3);
}

Axis logarithmic_axis(const std::string& title, const Extent& positive) {
  const double top = std::ceil(std::log10(positive.high));
  const double foot = std::max(std::floor(std::log10(positive.low)), top - 6.0);
  Axis axis{title, std::pow(10.0, foot), std::pow(10.0, top), {}, {}, true};
  for (double decade = foot; decade <= top; decade += 1.0) {
    axis.marks.push_back(std::pow(10.0, decade));
    axis.labels.push_back(decade_label(static_cast<int>(decade)));
  }
  return axis;
}

Axis value_axis(const std::vector<BrdfCurve>& curves) {
  constexpr double ratio_for_logarithm = 50.0;
  const std::string title = "BRDF [1/sr]";
  Extent positive;
  for (const BrdfCurve& curve : curves) {
    for (const double f_r : curve.f_r_per_sr) {
      if (std::isfinite(f_r) && f_r > 0.0) positive.take(f_r);
    }
  }
  if (positive.empty()) return linear_axis(title, 1.0);
  if (positive.high > ratio_for_logarithm * positive.low) return logarithmic_axis(title, positive);
  return linear_axis(title, positive.high);
}

void draw_curve(Canvas& canvas, const CartesianFrame& frame, const BrdfCurve& curve, const Pen& pen) {
  std::vector<Point> stroke;
  const auto finish = [&] {
    canvas.line(stroke, pen);
    stroke.clear();
  };
  for (std::size_t i = 0; i < curve.f_r_per_sr.size(); ++i) {
    const double f_r = curve.f_r_per_sr[i];
    const bool drawable = std::isfinite(f_r) && (f_r > 0.0 || !frame.y.logarithmic);
    if (drawable) stroke.push_back(frame.at(curve.theta_r_deg[i], f_r));
    if (!drawable) finish();
  }
  finish();
}

std::string label_of(const BrdfCurve& curve) {
  return "incidence " + number_label(curve.theta_i_deg, 6) + "°";
}

PlotHeader header_of(const std::vector<BrdfCurve>& curves, const std::string& title) {
  if (curves.size() == 1) return {title, label_of(curves.front()), {}};
  PlotHeader header{title, "", {}};
  for (std::size_t i = 0; i < curves.size(); ++i) header.legend.push_back({label_of(curves[i]), curve_pen(i)});
  return header;
}

}  // namespace

void draw_brdf_plot(const std::filesystem::path& png, const std::vector<BrdfCurve>& curves, const std::string& title) {
  require_valid(curves);
  Canvas canvas(1600, 1000);
  const double top = draw_header(canvas, header_of(curves, title));
  const CartesianFrame frame = draw_cartesian_frame(canvas, top, angle_axis(curves), value_axis(curves));
  canvas.clip(frame.box);
  for (std::size_t i = curves.size(); i-- > 0;) draw_curve(canvas, frame, curves[i], curve_pen(i));
  canvas.no_clip();
  draw_outline(canvas, frame);
  write_png(png, canvas.picture());
}

}  // namespace lrcs
