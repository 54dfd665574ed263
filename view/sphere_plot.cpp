#include "view/sphere_plot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "view/plot_file.h"
#include "view/plot_header.h"
#include "view/ticks.h"

namespace lrcs {
namespace {

constexpr Colour graticule_grey{0.6, 0.6, 0.6};
constexpr double margin_reach = 1.33;                   // with the names of the axes [radius]
constexpr double axis_reach = 1.16, name_reach = 1.27;  // [radius]

struct BodyAxis {
  Vec3 direction;
  const char* name;
};

std::array<BodyAxis, 6> body_axes() {
  return {{{Vec3::UnitX(), "x"},
           {Vec3::UnitY(), "y"},
           {Vec3::UnitZ(), "z"},
           {-Vec3::UnitX(), "−x"},
           {-Vec3::UnitY(), "−y"},
           {-Vec3::UnitZ(), "−z"}}};
}

// From the sphere outward: those that point away from the viewer before the sphere is drawn over them, the others
// after.
void draw_axes(Canvas& canvas, const SphereView& view, bool toward_viewer) {
  for (const BodyAxis& axis : body_axes()) {
    if (view.shows(axis.direction) != toward_viewer) continue;
    canvas.line({view.at(axis.direction), view.at(axis_reach * axis.direction)}, {ink, 4.0});
    canvas.text(view.at(name_reach * axis.direction), axis.name,
                {.font = mark_font, .x = AlignX::centre, .y = AlignY::middle, .halo = toward_viewer ? 0.7 : 0.0});
  }
}

std::string sphere_note(const std::string& colours) {
  const std::string frame = "x: forward, y: left, z: up; lines every 30°";
  return colours.empty() ? frame : frame + "\n" + colours;
}

std::string words_of(const AspectAngles& from) {
  return "seen from azimuth " + number_label(from.azimuth_deg, 6) + "°, elevation " +
         number_label(from.elevation_deg, 6) + "°";
}

AspectAngles opposite(const AspectAngles& from) {
  const double azimuth = from.azimuth_deg + 180.0;
  return {azimuth >= 360.0 ? azimuth - 360.0 : azimuth, 0.0 - from.elevation_deg};
}

SphereView draw_sphere(Canvas& canvas, const Box& box, const DirectionMap& map, const DecibelRange& range,
                       const AspectAngles& from) {
  constexpr double caption = 60.0;  // [pixel]
  const double middle = 0.5 * (box.low.x + box.high.x);
  const double radius = 0.5 / margin_reach * std::min(box.high.x - box.low.x, box.high.y - box.low.y - caption);
  SphereView view = sphere_view({middle, 0.5 * (box.low.y + caption + box.high.y)}, radius, from);
  draw_axes(canvas, view, false);
  canvas.disc(view.centre, view.radius, white);
  canvas.tiles(sphere_tiles(map, range, view));
  canvas.strokes(graticule(view, 30.0), {graticule_grey, 1.5});
  canvas.circle(view.centre, view.radius, {ink, 2.0});
  draw_axes(canvas, view, true);
  const double foot = view.centre.y - margin_reach * radius - caption;
  canvas.text({middle, foot + 10.0}, words_of(from),
              {.font = fitting(words_of(from), note_font, box.high.x - box.low.x - 20.0), .x = AlignX::centre});
  return view;
}

}  // namespace

SpherePair draw_sphere_plot(Canvas& canvas, const DirectionMap& map, const AspectAngles& from, const MapText& text) {
  constexpr double border = 26.0, half_gap = 14.0;  // [pixel]
  const DecibelRange range = map_range(map, text.floor_dbsm);
  const double top = draw_header(canvas, {text.title, sphere_note(map_note(map, range)), {}});
  const double right = canvas.width() - map_bar_room + 30.0, middle = 0.5 * (border + right);
  const SphereView front = draw_sphere(canvas, {{border, border}, {middle - half_gap, top}}, map, range, from);
  const SphereView back = draw_sphere(canvas, {{middle + half_gap, border}, {right, top}}, map, range, opposite(from));
  draw_map_bar(canvas, front.centre.y - front.radius, front.centre.y + front.radius, range);
  return {front, back};
}

void draw_sphere_plot(const std::filesystem::path& file, const DirectionMap& map, const AspectAngles& from,
                      const MapText& text) {
  Canvas canvas = plot_canvas(file, 1600, 1000);
  draw_sphere_plot(canvas, map, from, text);
  write_plot(file, canvas);
}

}  // namespace lrcs
