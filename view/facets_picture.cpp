#include "view/facets_picture.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/direction.h"
#include "view/facet_colours.h"
#include "view/plot_file.h"
#include "view/scale_bar.h"
#include "view/solid_drawing.h"
#include "view/ticks.h"

namespace lrcs {
namespace {

// All sizes of letters, lines and margins follow the picture's: `unit` is 1 at 1200 pixels' height.
struct Layout {
  double unit;
  double width;
  double height;

  [[nodiscard]] Font font(double size) const { return {static_cast<int>(std::lround(size * unit)), false}; }
  [[nodiscard]] Box target() const {
    return {{150.0 * unit, 190.0 * unit}, {width - 350.0 * unit, height - 150.0 * unit}};
  }
  [[nodiscard]] Box bar() const {
    return {{width - 200.0 * unit, 230.0 * unit}, {width - 160.0 * unit, height - 200.0 * unit}};
  }
};

void require_valid(const FacetMesh& mesh, const FacetResult& result, const Vec3& toward_receiver, const Vec3& up,
                   int width, int height) {
  const std::size_t facets = mesh.size();
  if (facets == 0) throw std::invalid_argument("a picture needs at least one facet");
  if (mesh.areas.size() != facets || mesh.normals.size() != facets || result.sigma_m2.size() != facets ||
      result.seen_fraction.size() != facets) {
    throw std::invalid_argument("a picture needs area, normal, sigma and seen fraction of every facet");
  }
  if (!(toward_receiver.norm() > 0.0) || !(up.norm() > 0.0)) {
    throw std::invalid_argument("a picture needs directions that are not zero");
  }
  if (std::min(width, height) < 400 || std::max(width, height) > 8000) {
    throw std::invalid_argument("a picture's width and height lie in 400..8000 pixels");
  }
}

Point plus(const Point& p, const Point& step, double factor) {
  return {p.x + factor * step.x, p.y + factor * step.y};
}

struct ArrowPen {
  Pen line;
  double barb;  // length of the head [pixel]
};

// A shaft and two barbs; a dot with a ring where the arrow points at the viewer.
void draw_arrow(Canvas& canvas, const Point& from, const Point& to, const ArrowPen& arrow) {
  const Pen& pen = arrow.line;
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  if (length < 0.8 * arrow.barb) {
    canvas.disc(from, 0.3 * arrow.barb, pen.colour);
    canvas.circle(from, 0.7 * arrow.barb, pen);
    return;
  }
  const Point along{(to.x - from.x) / length, (to.y - from.y) / length};
  const Point across{-along.y, along.x};
  const double barb = std::min(arrow.barb, 0.5 * length);
  const Point neck = plus(to, along, -barb);
  canvas.line({from, to}, pen);
  canvas.line({plus(neck, across, 0.5 * barb), to, plus(neck, across, -0.5 * barb)}, pen);
}

void draw_triad(Canvas& canvas, const Layout& layout, const ParallelView& view) {
  const Point origin{150.0 * layout.unit, 175.0 * layout.unit};
  const double size = 75.0 * layout.unit / view.pixels_a_metre;  // [m]
  const auto draw_axis = [&](const Vec3& axis, const char* name, const Colour& colour) {
    const Point step = view.step(size * axis);
    draw_arrow(canvas, origin, plus(origin, step, 1.0), {{colour, 4.0 * layout.unit}, 20.0 * layout.unit});
    canvas.text(plus(origin, step, 1.35), name,
                {.font = layout.font(32.0), .colour = colour, .x = AlignX::centre, .y = AlignY::middle, .halo = 0.7});
  };
  draw_axis(Vec3::UnitX(), "x", curve_colour(1));
  draw_axis(Vec3::UnitY(), "y", curve_colour(2));
  draw_axis(Vec3::UnitZ(), "z", curve_colour(0));
}

// From the target's middle outward, over everything: the sensor is on the viewer's side or the arrow runs behind, but
// it is the direction that is shown.
void draw_sensor(Canvas& canvas, const Layout& layout, const ParallelView& view, const Vec3& toward, const char* name) {
  const Box& box = view.box;
  const Point middle{0.5 * (box.low.x + box.high.x), 0.5 * (box.low.y + box.high.y)};
  const double reach = 0.45 * std::min(box.high.x - box.low.x, box.high.y - box.low.y);  // [pixel]
  const Point step = view.step(toward * (reach / view.pixels_a_metre));
  for (const Pen& pen : {Pen{white, 12.0 * layout.unit}, Pen{ink, 5.0 * layout.unit}}) {
    draw_arrow(canvas, plus(middle, step, 0.55), plus(middle, step, 1.1), {pen, 26.0 * layout.unit});
  }
  canvas.text(
      plus(middle, step, 1.2), name,
      {.font = layout.font(30.0), .x = step.x < 0.0 ? AlignX::right : AlignX::left, .y = AlignY::middle, .halo = 0.8});
}

std::string angles(double azimuth_deg, double elevation_deg) {
  return "azimuth " + number_label(azimuth_deg, 6) + "°, elevation " + number_label(elevation_deg, 6) + "°";
}

std::string lrcs_text(double sigma_m2) {
  const std::string text = "LRCS " + number_label(sigma_m2, 4) + " m²";
  return sigma_m2 > 0.0 ? text + " (" + tick_label(10.0 * std::log10(sigma_m2), 0.01) + " dBsm)" : text;
}

void draw_captions(Canvas& canvas, const Layout& layout, const FacetResult& result, bool monostatic) {
  const std::string receiver = angles(result.receiver_azimuth_deg, result.receiver_elevation_deg);
  const std::string transmitter = angles(result.transmitter_azimuth_deg, result.transmitter_elevation_deg);
  const std::string place =
      monostatic ? "monostatic, " + receiver : "transmitter " + transmitter + "; receiver " + receiver;
  const double room = layout.width - 60.0 * layout.unit;
  const Font large = layout.font(44.0);
  canvas.text({0.5 * layout.width, layout.height - 30.0 * layout.unit}, lrcs_text(result.sigma_total_m2),
              {.font = {large.size, true}, .x = AlignX::centre, .y = AlignY::top});
  canvas.text({0.5 * layout.width, 30.0 * layout.unit}, place,
              {.font = fitting(place, layout.font(36.0), room), .x = AlignX::centre});
}

}  // namespace

void draw_facets_picture(const std::filesystem::path& file, const FacetMesh& mesh, const FacetResult& result,
                         const Vec3& toward_receiver, const Vec3& up, int width, int height) {
  require_valid(mesh, result, toward_receiver, up, width, height);
  constexpr double raise = 25.0 * degree;
  constexpr double aside = 30.0 * degree;
  const Layout layout{std::min(height / 1200.0, width / 1600.0), static_cast<double>(width),
                      static_cast<double>(height)};
  const ParallelView view = view_of(mesh, oblique(toward_receiver, up, raise, aside), up, layout.target());
  Canvas canvas = plot_canvas(file, width, height);
  const ColouredFacets coloured = coloured_facets(mesh, result, {});
  canvas.paste(solid_drawing(mesh, coloured.colours, view, width, height), 0, 0);
  const Vec3 transmitter = direction_of({result.transmitter_azimuth_deg, result.transmitter_elevation_deg});
  const Vec3 receiver = toward_receiver.normalized();
  constexpr double same = 1e-6;  // [rad]
  const bool monostatic = (transmitter - receiver).norm() < same;
  if (!monostatic) draw_sensor(canvas, layout, view, transmitter, "transmitter");
  draw_sensor(canvas, layout, view, receiver, monostatic ? "sensor" : "receiver");
  draw_triad(canvas, layout, view);
  draw_scale(canvas, layout.bar(), 250.0 * layout.unit, coloured.scale, layout.font(30.0));
  draw_captions(canvas, layout, result, monostatic);
  write_plot(file, canvas);
}

}  // namespace lrcs
