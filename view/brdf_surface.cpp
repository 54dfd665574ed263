#include "view/brdf_surface.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "view/brdf_axes.h"
#include "view/colour_bar.h"
#include "view/hemisphere_surface.h"
#include "view/hemisphere_view.h"
#include "view/plot_file.h"
#include "view/plot_header.h"
#include "view/ticks.h"

namespace lrcs {
namespace {

constexpr double behind = HemisphereView::viewer_azimuth_deg + 180.0;  // the azimuth away from the viewer [deg]
constexpr double ray_step = 30.0;                                      // [deg]

bool rises(const std::vector<double>& values) {
  const auto finite = [](double value) { return std::isfinite(value); };
  return std::all_of(values.begin(), values.end(), finite) &&
         std::adjacent_find(values.begin(), values.end(), std::greater_equal<>()) == values.end();
}

void require_valid(const HemisphereValues& values) {
  const auto& theta = values.theta_r_deg;
  const auto& phi = values.phi_deg;
  if (theta.size() < 2 || phi.size() < 3 || values.value.size() != theta.size() * phi.size())
    throw std::invalid_argument("a surface needs a value at each of two or more theta_r and three or more phi");
  if (!rises(theta) || theta.front() != 0.0 || theta.back() > 90.0)
    throw std::invalid_argument("a surface needs theta_r rising from 0 to at most 90 deg");
  if (!rises(phi) || phi.front() < 0.0 || phi.back() >= 360.0)
    throw std::invalid_argument("a surface needs phi rising within [0, 360) deg");
  if (!std::all_of(values.value.begin(), values.value.end(), [](double v) { return std::isfinite(v) && v >= 0.0; }))
    throw std::invalid_argument("a surface needs finite values that are not negative");
}

HemisphereView view_below(double top, double largest_theta_deg) {
  constexpr double room_for_far_labels = 68.0;  // [pixel]
  HemisphereView view{{715.0, 378.0}, 530.0, 0.0, largest_theta_deg};
  view.rise = top - room_for_far_labels - view.at(largest_theta_deg, behind, 0.0).y;
  return view;
}

// The far half of the rim at a height, from the left end to the right one.
std::vector<Point> far_arc(const HemisphereView& view, double height) {
  std::vector<Point> arc;
  for (double aside = 90.0; aside >= -90.0; aside -= 2.0)
    arc.push_back(view.at(view.largest_theta_deg, behind + aside, height));
  return arc;
}

// A cylinder's far half behind the surface, ruled at the axis's marks and at multiples of 30 deg.
void draw_back_wall(Canvas& canvas, const HemisphereView& view, const Axis& axis) {
  std::vector<Point> outline = far_arc(view, 0.0);
  const std::vector<Point> top = far_arc(view, 1.0);
  outline.insert(outline.end(), top.rbegin(), top.rend());
  canvas.tiles({{outline, {0.975, 0.975, 0.975}}});
  for (const double phi : multiples(behind - 90.0, behind + 90.0, ray_step))
    canvas.line({view.at(view.largest_theta_deg, phi, 0.0), view.at(view.largest_theta_deg, phi, 1.0)},
                {grid_grey, 2.0});
  for (const double mark : axis.marks) canvas.line(far_arc(view, mark / axis.high), {grid_grey, 2.0});
  for (const double height : {0.0, 1.0}) canvas.line(far_arc(view, height), {ink, 2.0});
  for (const double side : {-90.0, 90.0})
    canvas.line(
        {view.at(view.largest_theta_deg, behind + side, 0.0), view.at(view.largest_theta_deg, behind + side, 1.0)},
        {ink, 2.0});
}

// The upright axis at the left end of the wall.
void draw_value_marks(Canvas& canvas, const HemisphereView& view, const Axis& axis) {
  constexpr double tick = 10.0, gap = 12.0, label_room = 104.0, title_gap = 130.0;  // [pixel]
  for (std::size_t i = 0; i < axis.marks.size(); ++i) {
    const Point at = view.at(view.largest_theta_deg, behind + 90.0, axis.marks[i] / axis.high);
    canvas.line({at, {at.x - tick, at.y}}, {ink, 2.0});
    canvas.text({at.x - tick - gap, at.y}, axis.labels[i],
                {.font = fitting(axis.labels[i], mark_font, label_room), .x = AlignX::right, .y = AlignY::middle});
  }
  const Point middle = view.at(view.largest_theta_deg, behind + 90.0, 0.5);
  canvas.text({middle.x - title_gap, middle.y}, axis.title,
              {.font = fitting(axis.title, axis_font, view.rise), .x = AlignX::centre, .upward = true});
}

void draw_azimuth(Canvas& canvas, const HemisphereView& view, double phi_deg, double height) {
  constexpr double tick = 12.0, gap = 34.0;  // [pixel]
  const Point at = view.at(view.largest_theta_deg, phi_deg, height);
  const Point middle = view.at(0.0, 0.0, height);
  const double length = std::hypot(at.x - middle.x, at.y - middle.y);
  const Point step{(at.x - middle.x) / length, (at.y - middle.y) / length};
  const auto outside = [&](double far) { return Point{at.x + far * step.x, at.y + far * step.y}; };
  canvas.line({at, outside(tick)}, {ink, 2.0});
  canvas.text(outside(tick + gap), tick_label(phi_deg < 0.0 ? phi_deg + 360.0 : phi_deg, 1.0) + "°",
              {.font = mark_font, .x = AlignX::centre, .y = AlignY::middle});
}

// Azimuths: of the near half below the rim, of the far half above the wall; not where the upright axis stands.
void draw_azimuths(Canvas& canvas, const HemisphereView& view) {
  constexpr double aside = 75.0;  // [deg]
  const double ahead = behind - 180.0;
  for (const double phi : multiples(ahead - aside, ahead + aside, ray_step)) draw_azimuth(canvas, view, phi, 0.0);
  for (const double phi : multiples(behind - aside, behind + aside, ray_step)) draw_azimuth(canvas, view, phi, 1.0);
  canvas.text({view.centre.x, 34.0}, "azimuth phi [deg] (rim), polar angle theta_r [deg] (rings)",
              {.font = axis_font, .x = AlignX::centre});
}

// theta_r on every other ring of the surface, between the two rays nearest to the viewer.
void draw_ring_labels(Canvas& canvas, const HemisphereView& view, const HemisphereValues& values, double full_scale) {
  constexpr double between_rays = 285.0;  // [deg]
  const auto ray = std::lower_bound(values.phi_deg.begin(), values.phi_deg.end(), between_rays);
  const std::size_t p = ray == values.phi_deg.end() ? 0 : static_cast<std::size_t>(ray - values.phi_deg.begin());
  for (std::size_t t = 1; t + 1 < values.theta_r_deg.size(); ++t) {
    const double theta = values.theta_r_deg[t];
    if (std::abs(theta - 20.0 * std::round(theta / 20.0)) > 1e-6) continue;
    const double height = values.value[t * values.phi_deg.size() + p] / full_scale;
    canvas.text(view.at(theta, values.phi_deg[p], height), tick_label(theta, 1.0) + "°",
                {.font = note_font, .x = AlignX::centre, .y = AlignY::middle, .halo = 0.75});
  }
}

}  // namespace

void draw_brdf_surface(const std::filesystem::path& file, const HemisphereValues& values, const SurfaceText& text) {
  require_valid(values);
  const double largest = std::max(text.full_scale, *std::max_element(values.value.begin(), values.value.end()));
  const Axis axis = linear_axis(text.value_axis, 0.0, largest > 0.0 ? largest : 1.0, 5);
  Canvas canvas = plot_canvas(file, 1600, 1300);
  const double top = draw_header(canvas, {text.title, text.note, {}});
  const HemisphereView view = view_below(top, values.theta_r_deg.back());
  draw_back_wall(canvas, view, axis);
  canvas.tiles(hemisphere_surface(values, axis.high, view));
  draw_value_marks(canvas, view, axis);
  draw_ring_labels(canvas, view, values, axis.high);
  draw_azimuths(canvas, view);
  draw_colour_bar(canvas, {{1390.0, view.centre.y}, {1434.0, view.centre.y + view.rise}}, axis);
  write_plot(file, canvas);
}

}  // namespace lrcs
