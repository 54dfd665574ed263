#include "view/canvas.h"

#include <vtkImageBlend.h>
#include <vtkImageData.h>
#include <vtkImageMapToColors.h>
#include <vtkImageTranslateExtent.h>
#include <vtkImplicitModeller.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "view/dashes.h"
#include "view/line_pieces.h"
#include "view/svg.h"

namespace lrcs {
namespace {

// How a mask's values become opacity: straight from one end of their range to the other, and constant beyond.
struct Ramp {
  double low, high;        // of the values
  double at_low, at_high;  // opacity [1]
};

vtkSmartPointer<vtkLookupTable> inks(const Colour& colour, const Ramp& ramp) {
  constexpr int levels = 256;
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(levels);
  table->SetTableRange(ramp.low, ramp.high);
  for (int level = 0; level < levels; ++level) {
    const double opacity = std::lerp(ramp.at_low, ramp.at_high, level / (levels - 1.0));
    table->SetTableValue(level, colour.red, colour.green, colour.blue, opacity);
  }
  return table;
}

Box grown(const Box& box, double margin) {
  return {{box.low.x - margin, box.low.y - margin}, {box.high.x + margin, box.high.y + margin}};
}

std::vector<Point> arc_points(const Point& centre, double radius) {
  constexpr double pixels_a_step = 3.0;
  const int steps = std::max(24, static_cast<int>(2.0 * std::numbers::pi * radius / pixels_a_step));
  std::vector<Point> points;
  for (int step = 0; step <= steps; ++step) {
    const double angle = 2.0 * std::numbers::pi * step / steps;
    points.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return points;
}

// How far the next letter would stand: ink may reach less far.
double advance(const std::string& text, const Font& font) {
  return text_size("H" + text + "H", font).width - text_size("HH", font).width;
}

double shift(AlignX align, double width) {
  if (align == AlignX::left) return 0.0;
  return align == AlignX::centre ? -0.5 * width : -width;
}

double shift(AlignY align, double cap_height) {
  if (align == AlignY::baseline) return 0.0;
  return align == AlignY::middle ? -0.5 * cap_height : -cap_height;
}

}  // namespace

Canvas::Canvas(int width, int height, Recording recording, double magnification)
    : sheet_{width, height, {}}, magnification_(magnification), recording_(recording) {
  if (width <= 0 || height <= 0 || !(magnification > 0.0))
    throw std::invalid_argument("a picture needs a width, a height and a magnification above zero");
  sheet_.rgb.assign(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255);
  no_clip();
}

Canvas::Canvas(Picture ground) : sheet_(std::move(ground)) {
  no_clip();
}

Pen Canvas::on_sheet(Pen pen) const {
  pen.width *= magnification_;
  for (double& length : pen.dash) length *= magnification_;
  return pen;
}

std::vector<Point> Canvas::on_sheet(std::vector<Point> points) const {
  for (Point& p : points) p = on_sheet(p);
  return points;
}

template <class Shape>
void Canvas::record(const Shape& shape) {
  if (recording_ == Recording::shapes) elements_.push_back(shape(SvgElements(sheet_.height)));
}

std::string Canvas::svg() const {
  if (recording_ != Recording::shapes) throw std::logic_error("this canvas records no shapes");
  std::vector<std::string> elements = elements_;
  if (in_clip_) elements.push_back(SvgElements::end_of_clip());
  return svg_document(sheet_.width, sheet_.height, elements);
}

void Canvas::clip(const Box& box) {
  no_clip();
  const Pixels inside = pixels_of(on_sheet(box));
  clip_ = {{inside.left + 0.0, inside.bottom + 0.0}, {inside.right + 0.0, inside.top + 0.0}};
  record([&](const SvgElements& svg) { return svg.clip(clip_, clips_); });
  ++clips_;
  in_clip_ = true;
}

void Canvas::no_clip() {
  clip_ = {{0.0, 0.0}, {sheet_.width + 0.0, sheet_.height + 0.0}};
  if (in_clip_) record([](const SvgElements& svg) { return svg.end_of_clip(); });
  in_clip_ = false;
}

Canvas::Pixels Canvas::pixels_of(const Box& box) const {
  const auto pixel = [](double place, double low, double high) {
    return static_cast<int>(std::min(high, std::max(low, place)));
  };
  return {
      pixel(std::floor(box.low.x), clip_.low.x, clip_.high.x), pixel(std::floor(box.low.y), clip_.low.y, clip_.high.y),
      pixel(std::ceil(box.high.x), clip_.low.x, clip_.high.x), pixel(std::ceil(box.high.y), clip_.low.y, clip_.high.y)};
}

void Canvas::lay(vtkAlgorithm* mask, int left, int bottom, const Pixels& area, vtkScalarsToColors* inks) {
  vtkNew<vtkImageTranslateExtent> placed;
  placed->SetInputConnection(mask->GetOutputPort());
  placed->SetTranslation(left, bottom, 0);
  vtkNew<vtkImageMapToColors> coloured;
  coloured->SetInputConnection(placed->GetOutputPort());
  coloured->SetLookupTable(inks);
  coloured->SetOutputFormatToRGBA();
  const auto sheet = image_on(sheet_.rgb.data(), sheet_.width, sheet_.height, 3);
  vtkNew<vtkImageBlend> blend;
  blend->SetInputData(sheet);
  blend->AddInputConnection(coloured->GetOutputPort());
  std::array<int, 6> extent{area.left, area.right - 1, area.bottom, area.top - 1, 0, 0};
  blend->UpdateExtent(extent.data());
  sheet->CopyAndCastFrom(blend->GetOutput(), extent.data());
}

void Canvas::blend(int column, int row, const Colour& colour, double opacity) {
  std::uint8_t* pixel = &sheet_.rgb[3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(sheet_.width) +
                                         static_cast<std::size_t>(column))];
  const std::array<double, 3> ink{colour.red, colour.green, colour.blue};
  for (std::size_t k = 0; k < 3; ++k)
    pixel[k] = static_cast<std::uint8_t>(std::lround(std::lerp(pixel[k], 255.0 * ink[k], opacity)));
}

void Canvas::fill(const Box& given, const Colour& colour, double opacity) {
  fill_pixels(on_sheet(given), colour, opacity);
}

void Canvas::fill_pixels(const Box& box, const Colour& colour, double opacity) {
  record([&](const SvgElements& svg) { return svg.fill(box, colour, opacity); });
  const Pixels area = pixels_of(box);
  // The share of a pixel between two places.
  const auto share = [](int pixel, double low, double high) {
    return std::max(0.0, std::min(high, pixel + 1.0) - std::max(low, pixel + 0.0));
  };
  for (int row = area.bottom; row < area.top; ++row)
    for (int column = area.left; column < area.right; ++column)
      blend(column, row, colour, opacity * share(row, box.low.y, box.high.y) * share(column, box.low.x, box.high.x));
}

void Canvas::line(const std::vector<Point>& given, const Pen& given_pen) {
  const std::vector<Point> points = on_sheet(given);
  const Pen pen = on_sheet(given_pen);
  record([&](const SvgElements& svg) { return svg.lines({points}, pen); });
  ink_lines(dashes(points, pen.dash), pen);
}

void Canvas::strokes(const std::vector<std::vector<Point>>& given, const Pen& given_pen) {
  std::vector<std::vector<Point>> strokes = given;
  for (std::vector<Point>& stroke : strokes) stroke = on_sheet(std::move(stroke));
  const Pen pen = on_sheet(given_pen);
  record([&](const SvgElements& svg) { return svg.lines(strokes, {pen.colour, pen.width}); });
  ink_lines(strokes, pen);
}

void Canvas::ink_lines(const std::vector<std::vector<Point>>& lines, const Pen& pen) {
  const double reach = 0.5 * (pen.width + 1.0);
  const auto pieces = line_pieces(lines, grown(clip_, reach));
  const double* bounds = pieces->GetBounds();
  const Pixels area = pixels_of(grown({{bounds[0], bounds[2]}, {bounds[1], bounds[3]}}, reach));
  if (area.empty()) return;
  const int columns = area.right - area.left;
  const int rows = area.top - area.bottom;
  const double beyond = 2.0 * (reach + columns + rows);  // VTK wants a volume: its second layer is out of reach
  vtkNew<vtkImplicitModeller> distance;
  distance->SetInputData(pieces);
  distance->SetSampleDimensions(columns + 1, rows + 1, 2);
  distance->SetModelBounds(area.left + 0.5, area.right + 0.5, area.bottom + 0.5, area.top + 0.5, 0.0, beyond);
  distance->AdjustBoundsOff();
  distance->CappingOff();
  distance->SetMaximumDistance(reach / beyond);
  // A pixel is covered by how far the line reaches beyond its middle, but never more than the line is wide.
  const Ramp ramp{0.5 * std::abs(pen.width - 1.0), reach, std::min(1.0, pen.width), 0.0};
  lay(distance, area.left, area.bottom, area, inks(pen.colour, ramp));
}

void Canvas::frame(const Box& box, const Pen& pen) {
  line({box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}, box.low}, pen);
}

void Canvas::circle(const Point& given, double given_radius, const Pen& given_pen) {
  const Point centre = on_sheet(given);
  const double radius = magnification_ * given_radius;
  const Pen pen = on_sheet(given_pen);
  record([&](const SvgElements& svg) { return svg.circle(centre, radius, pen); });
  ink_lines(dashes(arc_points(centre, radius), pen.dash), pen);
}

void Canvas::disc(const Point& given, double given_radius, const Colour& colour) {
  const Point centre = on_sheet(given);
  const double radius = magnification_ * given_radius;
  record([&](const SvgElements& svg) { return svg.disc(centre, radius, colour); });
  ink_lines({{centre}}, {colour, 2.0 * radius});
}

void Canvas::area(const std::vector<Point>& given, const Colour& colour, double opacity) {
  const std::vector<Point> outline = on_sheet(given);
  record([&](const SvgElements& svg) { return svg.area(outline, colour, opacity); });
  Picture painted = sheet_;
  paint_tiles(painted, clip_, {{outline, colour}});
  std::transform(sheet_.rgb.begin(), sheet_.rgb.end(), painted.rgb.begin(), sheet_.rgb.begin(),
                 [&](std::uint8_t below, std::uint8_t above) {
                   return static_cast<std::uint8_t>(std::lround(std::lerp(below, above, opacity)));
                 });
}

void Canvas::tiles(const std::vector<Tile>& given) {
  std::vector<Tile> tiles = given;
  for (Tile& tile : tiles) tile.outline = on_sheet(std::move(tile.outline));
  record([&](const SvgElements& svg) { return svg.tiles(tiles); });
  paint_tiles(sheet_, clip_, tiles);
}

void Canvas::paste(const Picture& picture, int left, int bottom) {
  if (magnification_ != 1.0) throw std::logic_error("a canvas that magnifies takes no pictures");
  record([&](const SvgElements& svg) { return svg.picture(picture, left, bottom); });
  const Pixels area =
      pixels_of({{left + 0.0, bottom + 0.0}, {left + 0.0 + picture.width, bottom + 0.0 + picture.height}});
  for (int row = area.bottom; row < area.top; ++row) {
    const auto from = 3 * (static_cast<std::ptrdiff_t>(row - bottom) * picture.width + area.left - left);
    const auto to = 3 * (static_cast<std::ptrdiff_t>(row) * sheet_.width + area.left);
    std::copy_n(picture.rgb.begin() + from, 3 * std::max(0, area.right - area.left), sheet_.rgb.begin() + to);
  }
}

void Canvas::text(const Point& given, const std::string& text, const TextStyle& given_style) {
  const Point anchor = on_sheet(given);
  TextStyle style = given_style;
  // Never wider than it was measured to be.
  style.font.size = std::max(1, static_cast<int>(magnification_ * given_style.font.size));
  const TextBitmap bitmap = text_bitmap(text, style.font);
  if (recording_ == Recording::none && !bitmap.has_every_letter) note_letters_without_font(text);
  const double dx = shift(style.x, bitmap.width);
  const double lift = shift(style.y, bitmap.capital);  // from the anchor to the baseline
  const double dy = lift - bitmap.baseline;
  const int left = static_cast<int>(std::lround(style.upward ? anchor.x - dy - bitmap.height : anchor.x + dx));
  const int bottom = static_cast<int>(std::lround(style.upward ? anchor.y + dx : anchor.y + dy));
  const int across = style.upward ? bitmap.height : bitmap.width;
  const int up = style.upward ? bitmap.width : bitmap.height;
  const Box ground{{static_cast<double>(left), static_cast<double>(bottom)},
                   {static_cast<double>(left + across), static_cast<double>(bottom + up)}};
  if (style.halo > 0.0) fill_pixels(ground, white, style.halo);
  record([&](const SvgElements& svg) {
    const Point baseline{anchor.x - (style.upward ? lift : 0.0), anchor.y + (style.upward ? 0.0 : lift)};
    // A viewer may have letters that no font here has.
    return svg.text(baseline, text, style, bitmap.has_every_letter ? advance(text, style.font) : 0.0);
  });
  const Pixels area = pixels_of(ground);
  for (int row = area.bottom; row < area.top; ++row)
    for (int column = area.left; column < area.right; ++column) {
      // Of the bitmap as it is read from left to right.
      const int along = style.upward ? row - bottom : column - left;
      const int above = style.upward ? left + across - 1 - column : row - bottom;
      const std::uint8_t coverage =
          bitmap.coverage[static_cast<std::size_t>(above) * static_cast<std::size_t>(bitmap.width) +
                          static_cast<std::size_t>(along)];
      if (coverage > 0) blend(column, row, style.colour, coverage / 255.0);
    }
}

TextSize text_size(const std::string& text, const Font& font) {
  const TextBitmap bitmap = text_bitmap(text, font);
  return {static_cast<double>(bitmap.width), static_cast<double>(bitmap.capital)};
}

Font fitting(const std::string& text, Font font, double room) {
  const int smallest = font.size / 2;
  while (font.size > smallest && text_size(text, font).width > room) --font.size;
  return font;
}

}  // namespace lrcs
