#include "view/aspect_sheet.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "base/compensated_sum.h"
#include "view/part_returns.h"
#include "view/scale_bar.h"
#include "view/shortened_text.h"
#include "view/ticks.h"

namespace lrcs {
namespace {

constexpr Colour picked_red{0.84, 0.1, 0.1};

// Widths, of the sheet's: where the target ends, and where curve and table begin. Between them is the colour bar.
constexpr double target_end = 0.445, curve_begin = 0.60;

// Short: in a pair of directions, for the line to keep its large letters.
std::string degrees(double azimuth_deg, double elevation_deg, bool is_short) {
  return (is_short ? "az " : "azimuth ") + number_label(azimuth_deg, 6) + (is_short ? "°, el " : "°, elevation ") +
         number_label(elevation_deg, 6) + "°";
}

std::string dbsm_words(double sigma_m2) {
  return sigma_m2 > 0.0 ? tick_label(10.0 * std::log10(sigma_m2), 0.01) : "−inf";
}

std::string aspect_words(const FacetResult& r) {
  const bool is_monostatic =
      r.transmitter_azimuth_deg == r.receiver_azimuth_deg && r.transmitter_elevation_deg == r.receiver_elevation_deg;
  const std::string receiver = degrees(r.receiver_azimuth_deg, r.receiver_elevation_deg, !is_monostatic);
  if (is_monostatic) return "monostatic, " + receiver;
  return "transmitter " + degrees(r.transmitter_azimuth_deg, r.transmitter_elevation_deg, true) + "; receiver " +
         receiver;
}

// A sweep may be sampled; its facets are not.
std::string sampled_words(double sigma_m2, double facets_m2) {
  constexpr double same = 1e-9;
  if (std::abs(sigma_m2 - facets_m2) <= same * facets_m2) return "";
  return "sampled; facets, exactly: " + number_label(facets_m2, 6) + " m²";
}

bool holds(const Box& box, const Point& p) {
  return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y;
}

}  // namespace

AspectSheet::AspectSheet(const ViewedSweep& sweep, int width, int height)
    : sweep_(sweep), width_(width), height_(height), unit_(std::min(width / 1600.0, height / 900.0)) {
  if (width < 640 || height < 360) throw std::invalid_argument("a sheet is at least 640 x 360 pixels");
}

Font AspectSheet::font(double size, bool bold) const {
  return {std::max(6, static_cast<int>(std::lround(size * unit_))), bold};
}

int AspectSheet::letters() const {
  return font(28.0).size;
}

Box AspectSheet::target() const {
  return {{0.0, std::floor(84.0 * unit_)}, {std::floor(target_end * width_), std::floor(height_ - 172.0 * unit_)}};
}

Box AspectSheet::curve_box() const {
  const double height = std::max(380.0 * unit_, 0.38 * height_);
  return {{std::ceil(curve_begin * width_), std::ceil(height_ - height)}, {width_, height_}};
}

Box AspectSheet::table_box() const {
  return {{curve_box().low.x + 24.0 * unit_, 84.0 * unit_}, {width_ - 24.0 * unit_, curve_box().low.y - 16.0 * unit_}};
}

Box AspectSheet::slider_box() const {
  return {{30.0 * unit_, 14.0 * unit_}, {width_ - 30.0 * unit_, 44.0 * unit_}};
}

const AspectSheet::Plot& AspectSheet::plot_of(std::size_t cut) {
  if (plot_ && plot_->cut == cut) return *plot_;
  const Box box = curve_box();
  constexpr double letters = 0.8;  // of those of a plot
  const double magnification = letters * unit_;
  Canvas canvas(static_cast<int>(box.high.x - box.low.x), static_cast<int>(box.high.y - box.low.y), Recording::none,
                magnification);
  const Curve& curve = sweep_.cuts[cut].curve;
  PlotText text = sweep_.axis;
  text.title = "";
  if (sweep_.cuts.size() > 1) text.angle_axis += ", " + curve.label;
  const CartesianFrame frame = draw_sweep_plot(canvas, {curve}, text);
  plot_ = Plot{cut, canvas.picture(), frame, magnification};
  return *plot_;
}

Point AspectSheet::on_curve(const ViewedSweep::Place& place) const {
  const Curve& curve = sweep_.cuts[place.cut].curve;
  const CartesianFrame& frame = plot_->frame;
  double angle = curve.angle_deg[place.point];
  if (angle < frame.x.low) angle += 360.0;
  if (angle > frame.x.high) angle -= 360.0;
  const double dbsm = 10.0 * std::log10(curve.sigma_m2[place.point]);
  const Point at = frame.at(angle, std::max(dbsm, frame.y.low));
  return {curve_box().low.x + plot_->magnification * at.x, curve_box().low.y + plot_->magnification * at.y};
}

void AspectSheet::draw_words(Canvas& canvas, const AspectFacts& facts) const {
  const FacetResult& r = *facts.result;
  const double room = curve_box().low.x - 40.0 * unit_;
  const auto line = [&](const std::string& text, double top, const Font& size, const Colour& colour) {
    canvas.text({20.0 * unit_, height_ - top * unit_}, text,
                {.font = fitting(text, size, room), .colour = colour, .y = AlignY::top});
  };
  line(sweep_.title, 16.0, font(34.0, true), ink);
  line(aspect_words(r), 60.0, font(30.0), ink);
  const double sigma = sweep_.sigma_m2[facts.row];
  line("LRCS " + number_label(sigma, 6) + " m² ± " + number_label(sweep_.bound_m2[facts.row], 2) + " m², " +
           dbsm_words(sigma) + " dBsm",
       100.0, font(30.0), ink);
  const std::string sampled = sampled_words(sigma, r.sigma_total_m2);
  line(sampled, 140.0, font(26.0), ink);
  double top = sampled.empty() ? 140.0 : 172.0;
  for (const std::string& text : facts.picked) {
    canvas.text({20.0 * unit_, height_ - top * unit_}, text,
                {.font = fitting(text, font(24.0), room), .colour = picked_red, .y = AlignY::top});
    top += 32.0;
  }
}

void AspectSheet::draw_marker(Canvas& canvas, const AspectFacts& facts) const {
  const ViewedSweep::Place place = sweep_.places[facts.row];
  const Point at = on_curve(place);
  const Box box = curve_box();
  const double low = box.low.y + plot_->magnification * plot_->frame.box.low.y;
  const double high = box.low.y + plot_->magnification * plot_->frame.box.high.y;
  canvas.line({{at.x, low}, {at.x, high}}, {curve_colour(1), 3.0 * unit_});
  const double size = 10.0 * unit_;
  if (sweep_.sigma_m2[facts.row] >= std::pow(10.0, 0.1 * plot_->frame.y.low))
    canvas.disc(at, size, curve_colour(1));
  else  // lies lower than the plot
    canvas.area({{at.x - size, at.y + size}, {at.x + size, at.y + size}, {at.x, at.y - size}}, curve_colour(1), 1.0);
}

void AspectSheet::draw_table(Canvas& canvas, const AspectFacts& facts) {
  constexpr std::size_t most = 10;
  const Box box = table_box();
  const auto& names = sweep_.mesh->part.names;
  const auto strongest = strongest_parts(facts.part_sigma, most);
  const double total = facts.result->sigma_total_m2;
  const double room = (box.high.y - box.low.y) / (static_cast<double>(std::min(most, names.size())) + 3.0);
  // Units can be read where ten parts leave small letters only.
  const Font plain = font(std::min(30.0, 0.62 * room / unit_)), bold{std::max(plain.size, font(25.0).size), true};
  const double row = std::min(room, 1.65 * plain.size);
  const double share_at = box.high.x, dbsm_at = share_at - 3.0 * bold.size, sigma_at = dbsm_at - 4.3 * bold.size;
  const double name_room = sigma_at - box.low.x - 5.0 * bold.size;
  const auto cells = [&](double y, const Font& size, const std::string& name, const Font& of_name,
                         const std::string& sigma, const std::string& dbsm, const std::string& share) {
    canvas.text({box.low.x, y}, name, {.font = of_name, .y = AlignY::middle});
    const std::vector<std::pair<double, std::string>> numbers{{sigma_at, sigma}, {dbsm_at, dbsm}, {share_at, share}};
    for (const auto& [x, text] : numbers)
      canvas.text({x, y}, text, {.font = size, .x = AlignX::right, .y = AlignY::middle});
  };
  table_rows_.clear();
  double y = box.high.y - 0.5 * row;
  const std::string heading = strongest.size() < most ? "returning parts" : "strongest parts";
  cells(y, bold, heading, fitting(heading, bold, name_room), "LRCS [m²]", "[dBsm]", "[%]");
  canvas.line({{box.low.x, y - 0.5 * row}, {box.high.x, y - 0.5 * row}}, {ink, 1.5 * unit_});
  std::vector<std::string> shown_names;
  shown_names.reserve(strongest.size());
  for (const std::uint32_t part : strongest) shown_names.push_back(names[part].empty() ? "(no name)" : names[part]);
  const ShortenedTexts shown = shortened_apart(shown_names, plain, name_room);
  for (std::size_t k = 0; k < strongest.size(); ++k) {
    const std::uint32_t part = strongest[k];
    y -= row;
    const double sigma = facts.part_sigma[part];
    table_rows_.push_back({{{box.low.x, y - 0.5 * row}, {box.high.x, y + 0.5 * row}}, part});
    if (facts.part == part) canvas.fill(table_rows_.back().first, {1.0, 0.88, 0.85});
    cells(y, plain, shown.texts[k], shown.font, number_label(sigma, 4), dbsm_words(sigma),
          tick_label(100.0 * sigma / total, 0.1));
  }
  const auto returning = strongest_parts(facts.part_sigma, facts.part_sigma.size());
  if (const std::size_t others = returning.size() - strongest.size(); others > 0) {
    CompensatedSum rest;
    for (std::size_t k = strongest.size(); k < returning.size(); ++k) rest.add(facts.part_sigma[returning[k]]);
    y -= row;
    cells(y, plain, others == 1 ? "1 other" : std::to_string(others) + " others", plain, number_label(rest.value(), 4),
          dbsm_words(rest.value()), tick_label(100.0 * rest.value() / total, 0.1));
  }
  y -= row;
  canvas.line({{box.low.x, y + 0.5 * row}, {box.high.x, y + 0.5 * row}}, {ink, 1.5 * unit_});
  const Font sum{plain.size, true};
  cells(y, sum, "all", sum, number_label(total, 4), dbsm_words(total), total > 0.0 ? "100.0" : "−");
}

void AspectSheet::draw_slider(Canvas& canvas, const AspectFacts& facts) const {
  const Box box = slider_box();
  const double y = 0.5 * (box.low.y + box.high.y);
  const std::size_t rows = sweep_.places.size();
  const double share = rows > 1 ? static_cast<double>(facts.row) / (static_cast<double>(rows) - 1.0) : 0.0;
  canvas.line({{box.low.x, y}, {box.high.x, y}}, {grid_grey, 6.0 * unit_});
  canvas.disc({std::lerp(box.low.x, box.high.x, share), y}, 10.0 * unit_, curve_colour(0));
  canvas.text({box.low.x, box.high.y + 6.0 * unit_},
              "row " + std::to_string(facts.row) + " of 0 to " + std::to_string(rows - 1), {.font = font(24.0)});
  if (facts.keys.empty()) return;
  const double room = 0.78 * width_;
  canvas.text({box.high.x, box.high.y + 6.0 * unit_}, facts.keys,
              {.font = fitting(facts.keys, font(20.0), room), .colour = {0.35, 0.35, 0.35}, .x = AlignX::right});
}

Picture AspectSheet::drawn(const AspectFacts& facts) {
  Canvas canvas(static_cast<int>(width_), static_cast<int>(height_));
  const Plot& plot = plot_of(sweep_.places[facts.row].cut);
  canvas.paste(plot.picture, static_cast<int>(curve_box().low.x), static_cast<int>(curve_box().low.y));
  const Font letters = font(30.0);
  const double bar = target().high.x + 1.8 * letters.size;
  draw_scale(canvas, {{bar, target().low.y + 3.0 * letters.size}, {bar + 24.0 * unit_, target().high.y - 40.0 * unit_}},
             curve_box().low.x - target().high.x - 8.0 * unit_, facts.scale, letters);
  draw_words(canvas, facts);
  draw_marker(canvas, facts);
  draw_table(canvas, facts);
  draw_slider(canvas, facts);
  return canvas.picture();
}

std::optional<std::size_t> AspectSheet::row_at(const Point& at) const {
  Box slider = slider_box();
  if (at.y <= slider.high.y && at.x >= 0.0) {
    const double share = std::clamp((at.x - slider.low.x) / (slider.high.x - slider.low.x), 0.0, 1.0);
    return static_cast<std::size_t>(std::lround(share * (static_cast<double>(sweep_.places.size()) - 1.0)));
  }
  if (!plot_ || !holds(curve_box(), at)) return std::nullopt;
  const ViewedCut& cut = sweep_.cuts[plot_->cut];
  std::size_t nearest = 0;
  double apart = std::numeric_limits<double>::infinity();
  for (std::size_t point = 0; point < cut.rows.size(); ++point)
    if (const double x = std::abs(on_curve({plot_->cut, point}).x - at.x); x < apart) apart = x, nearest = point;
  return cut.rows[nearest];
}

std::optional<std::uint32_t> AspectSheet::part_at(const Point& at) const {
  for (const auto& [box, part] : table_rows_)
    if (holds(box, at)) return part;
  return std::nullopt;
}

}  // namespace lrcs
