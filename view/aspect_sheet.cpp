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

std::string degrees(double azimuth_deg, double elevation_deg) {
  return "azimuth " + number_label(azimuth_deg, 6) + "°, elevation " + number_label(elevation_deg, 6) + "°";
}

std::string dbsm_words(double sigma_m2) {
  return sigma_m2 > 0.0 ? tick_label(10.0 * std::log10(sigma_m2), 0.01) : "−inf";
}

std::string aspect_words(const FacetResult& r) {
  const bool is_monostatic =
      r.transmitter_azimuth_deg == r.receiver_azimuth_deg && r.transmitter_elevation_deg == r.receiver_elevation_deg;
  const std::string receiver = degrees(r.receiver_azimuth_deg, r.receiver_elevation_deg);
  if (is_monostatic) return "monostatic, " + receiver;
  return "transmitter " + degrees(r.transmitter_azimuth_deg, r.transmitter_elevation_deg) + "; receiver " + receiver;
}

// A sweep may be sampled; its facets are not.
std::string sampled_words(double sigma_m2, double facets_m2) {
  constexpr double same = 1e-9;
  if (std::abs(sigma_m2 - facets_m2) <= same * facets_m2) return "";
  return "; facets, exactly: " + number_label(facets_m2, 6) + " m²";
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
  return font(20.0).size;
}

Box AspectSheet::target() const {
  return {{0.0, std::floor(70.0 * unit_)}, {std::floor(0.50 * width_), std::floor(height_ - 100.0 * unit_)}};
}

Box AspectSheet::curve_box() const {
  return {{std::ceil(0.61 * width_), std::ceil(0.50 * height_)}, {width_, height_}};
}

Box AspectSheet::table_box() const {
  return {{0.63 * width_, 80.0 * unit_}, {width_ - 24.0 * unit_, 0.48 * height_}};
}

Box AspectSheet::slider_box() const {
  return {{30.0 * unit_, 14.0 * unit_}, {width_ - 30.0 * unit_, 44.0 * unit_}};
}

const AspectSheet::Plot& AspectSheet::plot_of(std::size_t cut) {
  if (plot_ && plot_->cut == cut) return *plot_;
  const Box box = curve_box();
  const int fine = std::max(1, static_cast<int>(std::lround(2.0 / unit_)));
  Canvas canvas(fine * static_cast<int>(box.high.x - box.low.x), fine * static_cast<int>(box.high.y - box.low.y));
  const Curve& curve = sweep_.cuts[cut].curve;
  PlotText text = sweep_.axis;
  text.title = sweep_.cuts.size() > 1 ? curve.label : "";
  const CartesianFrame frame = draw_sweep_plot(canvas, {curve}, text);
  plot_ = Plot{cut, shrunk(canvas.picture(), fine), frame, fine};
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
  return {curve_box().low.x + at.x / plot_->fine, curve_box().low.y + at.y / plot_->fine};
}

void AspectSheet::draw_words(Canvas& canvas, const AspectFacts& facts) const {
  const FacetResult& r = *facts.result;
  const double room = 0.59 * width_;
  const auto line = [&](const std::string& text, double top, const Font& size, const Colour& colour) {
    canvas.text({20.0 * unit_, height_ - top * unit_}, text,
                {.font = fitting(text, size, room), .colour = colour, .y = AlignY::top});
  };
  line(sweep_.title, 14.0, font(22.0, true), ink);
  line(aspect_words(r), 44.0, font(20.0), ink);
  const double sigma = sweep_.sigma_m2[facts.row];
  line("LRCS " + number_label(sigma, 6) + " m² ± " + number_label(sweep_.bound_m2[facts.row], 2) + " m², " +
           dbsm_words(sigma) + " dBsm" + sampled_words(sigma, r.sigma_total_m2),
       72.0, font(20.0), ink);
  double top = 108.0;
  for (const std::string& text : facts.picked) {
    canvas.text({20.0 * unit_, height_ - top * unit_}, text,
                {.font = fitting(text, font(18.0), 0.45 * width_), .colour = picked_red, .y = AlignY::top});
    top += 24.0;
  }
}

void AspectSheet::draw_marker(Canvas& canvas, const AspectFacts& facts) const {
  const ViewedSweep::Place place = sweep_.places[facts.row];
  const Point at = on_curve(place);
  const Box box = curve_box();
  const double low = box.low.y + plot_->frame.box.low.y / plot_->fine;
  const double high = box.low.y + plot_->frame.box.high.y / plot_->fine;
  canvas.line({{at.x, low}, {at.x, high}}, {curve_colour(1), 2.0 * unit_});
  canvas.disc(at, 6.0 * unit_, curve_colour(1));
}

void AspectSheet::draw_table(Canvas& canvas, const AspectFacts& facts) {
  constexpr std::size_t most = 10;
  const Box box = table_box();
  const auto& names = sweep_.mesh->part.names;
  const auto strongest = strongest_parts(facts.part_sigma, most);
  const double total = facts.result->sigma_total_m2;
  const double row = (box.high.y - box.low.y) / (most + 3.0);
  const Font plain = font(std::min(18.0, 0.62 * row / unit_)), bold{plain.size, true};
  const double sigma_at = box.high.x - 185.0 * unit_, dbsm_at = box.high.x - 80.0 * unit_, share_at = box.high.x;
  const auto cells = [&](double y, const Font& size, const std::string& name, const std::string& sigma,
                         const std::string& dbsm, const std::string& share) {
    canvas.text({box.low.x + 6.0 * unit_, y}, shortened(name, size, sigma_at - box.low.x - 120.0 * unit_),
                {.font = size, .y = AlignY::middle});
    const std::vector<std::pair<double, std::string>> numbers{{sigma_at, sigma}, {dbsm_at, dbsm}, {share_at, share}};
    for (const auto& [x, text] : numbers)
      canvas.text({x, y}, text, {.font = size, .x = AlignX::right, .y = AlignY::middle});
  };
  table_rows_.clear();
  double y = box.high.y - 0.5 * row;
  cells(y, bold, strongest.size() < most ? "parts that return" : "ten strongest parts", "LRCS [m²]", "[dBsm]", "[%]");
  canvas.line({{box.low.x, y - 0.5 * row}, {box.high.x, y - 0.5 * row}}, {ink, 1.5 * unit_});
  for (const std::uint32_t part : strongest) {
    y -= row;
    const double sigma = facts.part_sigma[part];
    table_rows_.push_back({{{box.low.x, y - 0.5 * row}, {box.high.x, y + 0.5 * row}}, part});
    if (facts.part == part) canvas.fill(table_rows_.back().first, {1.0, 0.88, 0.85});
    cells(y, plain, names[part].empty() ? "(no name)" : names[part], number_label(sigma, 5), dbsm_words(sigma),
          tick_label(100.0 * sigma / total, 0.1));
  }
  const auto returning = strongest_parts(facts.part_sigma, facts.part_sigma.size());
  if (const std::size_t others = returning.size() - strongest.size(); others > 0) {
    CompensatedSum rest;
    for (std::size_t k = strongest.size(); k < returning.size(); ++k) rest.add(facts.part_sigma[returning[k]]);
    y -= row;
    cells(y, plain, others == 1 ? "1 other" : std::to_string(others) + " others", number_label(rest.value(), 5),
          dbsm_words(rest.value()), tick_label(100.0 * rest.value() / total, 0.1));
  }
  y -= row;
  canvas.line({{box.low.x, y + 0.5 * row}, {box.high.x, y + 0.5 * row}}, {ink, 1.5 * unit_});
  cells(y, bold, "all", number_label(total, 5), dbsm_words(total), total > 0.0 ? "100" : "−");
}

void AspectSheet::draw_slider(Canvas& canvas, const AspectFacts& facts) const {
  const Box box = slider_box();
  const double y = 0.5 * (box.low.y + box.high.y);
  const std::size_t rows = sweep_.places.size();
  const double share = rows > 1 ? static_cast<double>(facts.row) / (static_cast<double>(rows) - 1.0) : 0.0;
  canvas.line({{box.low.x, y}, {box.high.x, y}}, {grid_grey, 6.0 * unit_});
  canvas.disc({std::lerp(box.low.x, box.high.x, share), y}, 10.0 * unit_, curve_colour(0));
  canvas.text({box.low.x, box.high.y + 6.0 * unit_},
              "row " + std::to_string(facts.row) + " of 0 to " + std::to_string(rows - 1), {.font = font(16.0)});
  if (facts.keys.empty()) return;
  const double room = 0.8 * width_;
  canvas.text({box.high.x, box.high.y + 6.0 * unit_}, facts.keys,
              {.font = fitting(facts.keys, font(16.0), room), .colour = {0.35, 0.35, 0.35}, .x = AlignX::right});
}

Picture AspectSheet::drawn(const AspectFacts& facts) {
  Canvas canvas(static_cast<int>(width_), static_cast<int>(height_));
  const Plot& plot = plot_of(sweep_.places[facts.row].cut);
  canvas.paste(plot.picture, static_cast<int>(curve_box().low.x), static_cast<int>(curve_box().low.y));
  draw_scale(canvas, {{0.535 * width_, target().low.y + 60.0 * unit_}, {0.55 * width_, target().high.y - 30.0 * unit_}},
             curve_box().low.x - 0.505 * width_ - 16.0 * unit_, facts.scale, font(17.0));
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
