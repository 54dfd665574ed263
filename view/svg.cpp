#include "view/svg.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "view/readable_text.h"

namespace lrcs {
namespace {

// To 1/1000, without zeros at the end.
std::string decimal(double value) {
  std::string text = fmt::format("{:.3f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string hexadecimal(const Colour& colour) {
  const Rgb rgb = rgb_of(colour);
  return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

std::string opacity_attribute(double opacity) {
  return opacity < 1.0 ? fmt::format(" fill-opacity=\"{}\"", decimal(opacity)) : "";
}

std::string stroke_attributes(const Pen& pen) {
  std::string text =
      fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"", hexadecimal(pen.colour), decimal(pen.width));
  if (pen.dash.empty()) return text;
  std::vector<std::string> lengths;
  for (const double length : pen.dash) lengths.push_back(decimal(length));
  return text + fmt::format(" stroke-dasharray=\"{}\"", fmt::join(lengths, " "));
}

bool is_finite_point(const Point& p) {
  return std::isfinite(p.x) && std::isfinite(p.y);
}

// The line's pieces between points that are not finite.
std::vector<std::vector<Point>> finite_pieces(const std::vector<Point>& line) {
  std::vector<std::vector<Point>> pieces(1);
  for (const Point& p : line) {
    if (is_finite_point(p)) pieces.back().push_back(p);
    if (!is_finite_point(p) && !pieces.back().empty()) pieces.emplace_back();
  }
  if (pieces.back().empty()) pieces.pop_back();
  return pieces;
}

// Edges along the axes stay smooth without half-covered pixels.
bool is_upright_box(const Tile& tile) {
  for (std::size_t i = 0; i < tile.outline.size(); ++i) {
    const Point &p = tile.outline[i], &next = tile.outline[(i + 1) % tile.outline.size()];
    if (p.x != next.x && p.y != next.y) return false;
  }
  return true;
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : readable(text)) {
    if (c == '&') safe += "&amp;";
    if (c == '<') safe += "&lt;";
    if (c == '>') safe += "&gt;";
    if (c != '&' && c != '<' && c != '>') safe += c;
  }
  return safe;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8U | (k < count ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? digits[group >> (18U - 6U * k) & 63U] : '=';
  }
  return text;
}

const char* anchor_name(AlignX align) {
  if (align == AlignX::left) return "start";
  return align == AlignX::centre ? "middle" : "end";
}

}  // namespace

std::string SvgElements::points(const std::vector<Point>& points) const {
  std::string text;
  for (const Point& p : points)
    text += fmt::format("{}{},{}", text.empty() ? "" : " ", decimal(p.x), decimal(height_ - p.y));
  return text;
}

std::string SvgElements::rectangle(const Box& box) const {
  return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"", decimal(box.low.x),
                     decimal(height_ - box.high.y), decimal(box.high.x - box.low.x), decimal(box.high.y - box.low.y));
}

std::string SvgElements::fill(const Box& box, const Colour& colour, double opacity) const {
  return fmt::format("{} fill=\"{}\"{}/>", rectangle(box), hexadecimal(colour), opacity_attribute(opacity));
}

std::string SvgElements::lines(const std::vector<std::vector<Point>>& lines, const Pen& pen) const {
  std::string path;
  for (const auto& line : lines)
    for (const auto& piece : finite_pieces(line))
      // A line without length shows its round ends.
      path += "M" + points(piece.size() > 1 ? piece : std::vector<Point>{piece.front(), piece.front()});
  return path.empty() ? "" : fmt::format("<path d=\"{}\" {}/>", path, stroke_attributes(pen));
}

std::string SvgElements::circle(const Point& centre, double radius, const Pen& pen) const {
  return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>", decimal(centre.x), decimal(height_ - centre.y),
                     decimal(radius), stroke_attributes(pen));
}

std::string SvgElements::disc(const Point& centre, double radius, const Colour& colour) const {
  if (!is_finite_point(centre)) return "";
  return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\"/>", decimal(centre.x),
                     decimal(height_ - centre.y), decimal(radius), hexadecimal(colour));
}

std::string SvgElements::area(const std::vector<Point>& outline, const Colour& colour, double opacity) const {
  if (outline.empty() || !std::all_of(outline.begin(), outline.end(), is_finite_point)) return "";
  return fmt::format("<polygon points=\"{}\" fill=\"{}\"{}/>", points(outline), hexadecimal(colour),
                     opacity_attribute(opacity));
}

std::string SvgElements::tiles(const std::vector<Tile>& tiles) const {
  const bool upright = std::all_of(tiles.begin(), tiles.end(), is_upright_box);
  std::string text = fmt::format("<g stroke-width=\"{}\" fill-rule=\"evenodd\"{}>", upright ? "0.5" : "1",
                                 upright ? " shape-rendering=\"crispEdges\"" : "");
  for (const Tile& tile : tiles) {
    if (!std::all_of(tile.outline.begin(), tile.outline.end(), is_finite_point)) continue;
    const std::string colour = hexadecimal(tile.colour);
    text += fmt::format("\n<polygon points=\"{}\" fill=\"{}\" stroke=\"{}\"/>", points(tile.outline), colour, colour);
  }
  return text + "\n</g>";
}

std::string SvgElements::picture(const Picture& picture, int left, int bottom) const {
  return fmt::format("<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" xlink:href=\"data:image/png;base64,{}\"/>",
                     left, decimal(height_ - bottom - picture.height), picture.width, picture.height,
                     base64(png_bytes(picture)));
}

std::string SvgElements::text(const Point& baseline, const std::string& text, const TextStyle& style,
                              double width) const {
  if (text.empty()) return "";
  const std::string x = decimal(baseline.x), y = decimal(height_ - baseline.y);
  std::string attributes = fmt::format("x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\" text-anchor=\"{}\"", x, y,
                                       style.font.size, hexadecimal(style.colour), anchor_name(style.x));
  if (width > 0.0) attributes += fmt::format(" textLength=\"{}\" lengthAdjust=\"spacingAndGlyphs\"", decimal(width));
  if (style.font.bold) attributes += " font-weight=\"bold\"";
  if (style.upward) attributes += fmt::format(" transform=\"rotate(-90 {} {})\"", x, y);
  return fmt::format("<text {}>{}</text>", attributes, escaped(text));
}

std::string SvgElements::clip(const Box& box, std::size_t number) const {
  return fmt::format("<clipPath id=\"clip{}\">{}/></clipPath>\n<g clip-path=\"url(#clip{})\">", number, rectangle(box),
                     number);
}

std::string svg_document(int width, int height, const std::vector<std::string>& elements) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
      "xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"Arial, Liberation Sans, Helvetica, sans-serif\" stroke-linecap=\"round\" "
      "stroke-linejoin=\"round\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
      width, height);
  for (const std::string& element : elements)
    if (!element.empty()) text += element + "\n";
  return text + "</svg>\n";
}

}  // namespace lrcs
