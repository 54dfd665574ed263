#include "view/stacked_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "base/compensated_sum.h"
#include "view/brdf_axes.h"
#include "view/plot_header.h"
#include "view/shortened_text.h"
#include "view/ticks.h"

namespace lrcs {
namespace {

constexpr std::size_t most_layers = 7;
constexpr Colour others_grey{0.78, 0.78, 0.78};

void require_valid(const LayerStack& stack) {
  const auto refuse = [](const char* what) { throw std::invalid_argument(std::string("stacked layers: ") + what); };
  const std::size_t angles = stack.angle_deg.size();
  if (angles < 2) refuse("two angles or more are needed");
  if (!std::is_sorted(stack.angle_deg.begin(), stack.angle_deg.end())) refuse("the angles must rise");
  if (stack.layers.size() > most_layers) refuse("there are too many to be told apart");
  const auto check = [&](const std::vector<double>& sigma) {
    if (sigma.size() != angles) refuse("one value an angle is needed");
    if (!std::all_of(sigma.begin(), sigma.end(), [](double s) { return std::isfinite(s) && s >= 0.0; }))
      refuse("a LRCS is not finite and >= 0");
  };
  for (const StackLayer& layer : stack.layers) check(layer.sigma_m2);
  if (!stack.others_m2.empty()) check(stack.others_m2);
}

// Lighter than a curve of that number: areas are large.
Colour layer_colour(std::size_t layer) {
  constexpr double lightness = 0.3;
  const Colour colour = curve_colour(layer);
  return {std::lerp(colour.red, 1.0, lightness), std::lerp(colour.green, 1.0, lightness),
          std::lerp(colour.blue, 1.0, lightness)};
}

// Without their beginnings, but told apart where they are told apart in full.
std::vector<std::string> labels_of(const std::vector<StackLayer>& layers, double width) {
  constexpr double widest = 0.85, growth = 1.2;
  const auto shortened_to = [&](double room) {
    std::vector<std::string> labels;
    labels.reserve(layers.size());
    for (const StackLayer& layer : layers)
      labels.push_back(shortened(layer.label.empty() ? "(no name)" : layer.label, note_font, room));
    return labels;
  };
  const auto different = [](const std::vector<std::string>& labels) {
    return std::set<std::string>(labels.begin(), labels.end()).size();
  };
  const std::size_t in_full = different(shortened_to(std::numeric_limits<double>::infinity()));
  double room = 0.25 * width;
  std::vector<std::string> labels = shortened_to(room);
  while (different(labels) < in_full && room < widest * width) labels = shortened_to(room *= growth);
  return labels;
}

PlotHeader header_of(const LayerStack& stack, const StackText& text, double width) {
  const auto entry = [](const std::string& label, const Colour& colour) {
    return LegendEntry{.label = label, .pen = {colour}, .is_area = true};
  };
  PlotHeader header{text.title, text.note, {}};
  const std::vector<std::string> labels = labels_of(stack.layers, width);
  for (std::size_t k = 0; k < labels.size(); ++k) header.legend.push_back(entry(labels[k], layer_colour(k)));
  if (!stack.others_m2.empty()) header.legend.push_back(entry("others", others_grey));
  return header;
}

// The heights between the layers, the lowest 0.
std::vector<std::vector<double>> heights_of(const LayerStack& stack) {
  std::vector<CompensatedSum> sums(stack.angle_deg.size());
  std::vector<std::vector<double>> heights{std::vector<double>(sums.size(), 0.0)};
  const auto add = [&](const std::vector<double>& sigma) {
    heights.emplace_back();
    for (std::size_t i = 0; i < sums.size(); ++i) {
      sums[i].add(sigma[i]);
      heights.back().push_back(sums[i].value());
    }
  };
  for (const StackLayer& layer : stack.layers) add(layer.sigma_m2);
  if (!stack.others_m2.empty()) add(stack.others_m2);
  return heights;
}

std::vector<Point> points_along(const CartesianFrame& frame, const LayerStack& stack,
                                const std::vector<double>& heights) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < heights.size(); ++i) points.push_back(frame.at(stack.angle_deg[i], heights[i]));
  return points;
}

void draw_layers(Canvas& canvas, const CartesianFrame& frame, const LayerStack& stack,
                 const std::vector<std::vector<double>>& heights) {
  for (std::size_t k = 0; k + 1 < heights.size(); ++k) {
    std::vector<Point> outline = points_along(frame, stack, heights[k]);
    const std::vector<Point> top = points_along(frame, stack, heights[k + 1]);
    outline.insert(outline.end(), top.rbegin(), top.rend());
    canvas.tiles({{outline, k < stack.layers.size() ? layer_colour(k) : others_grey}});
  }
  canvas.line(points_along(frame, stack, heights.back()), {ink, 2.5});
}

Axis angle_axis_of(const LayerStack& stack, const std::string& title) {
  Axis axis{title, stack.angle_deg.front(), stack.angle_deg.back(), {}, {}};
  const double step = angle_step(axis.high - axis.low, 12);
  axis.marks = multiples(axis.low, axis.high, step);
  for (const double mark : axis.marks) axis.labels.push_back(tick_label(mark, step));
  return axis;
}

}  // namespace

std::vector<double> stack_top(const LayerStack& stack) {
  require_valid(stack);
  return heights_of(stack).back();
}

CartesianFrame draw_stacked_plot(Canvas& canvas, const LayerStack& stack, const StackText& text) {
  require_valid(stack);
  const auto heights = heights_of(stack);
  const double highest = *std::max_element(heights.back().begin(), heights.back().end());
  const Axis y = linear_axis("LRCS [m²]", 0.0, highest > 0.0 ? highest : 1.0);
  const double top = draw_header(canvas, header_of(stack, text, canvas.width()));
  CartesianFrame frame = draw_cartesian_frame(canvas, top, angle_axis_of(stack, text.angle_axis), y);
  draw_layers(canvas, frame, stack, heights);
  draw_outline(canvas, frame);
  return frame;
}

}  // namespace lrcs
