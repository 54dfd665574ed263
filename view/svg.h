#pragma once
#include <string>
#include <vector>

#include "view/canvas.h"

namespace lrcs {

// The shapes of a canvas as elements of an SVG file, one string each.
// frame: the canvas': y up, turned here; an element knows the canvas' height.
// laws: the same shapes give the same bytes. error: coordinates to 1/1000 pixel.
// domain: a point that is not finite breaks a line; what is left without points gives "".
// check: tests/view/svg_test.cpp reads them back.
class SvgElements {
 public:
  explicit SvgElements(double height) : height_(height) {}

  [[nodiscard]] std::string fill(const Box& box, const Colour& colour, double opacity) const;
  [[nodiscard]] std::string lines(const std::vector<std::vector<Point>>& lines, const Pen& pen) const;
  [[nodiscard]] std::string circle(const Point& centre, double radius, const Pen& pen) const;
  [[nodiscard]] std::string disc(const Point& centre, double radius, const Colour& colour) const;
  [[nodiscard]] std::string area(const std::vector<Point>& outline, const Colour& colour, double opacity) const;
  // One group. Each tile has a thin rim of its own colour, for renderers not to leave seams between neighbours.
  [[nodiscard]] std::string tiles(const std::vector<Tile>& tiles) const;
  // Embedded as PNG.
  [[nodiscard]] std::string picture(const Picture& picture, int left, int bottom) const;
  // `baseline`: where the text's anchor lies on the line that letters stand on. `width`: that it shall take [pixel];
  // 0: as the viewer's font has it.
  [[nodiscard]] std::string text(const Point& baseline, const std::string& text, const TextStyle& style,
                                 double width) const;
  // A group that is left open: to be ended by end_of_clip().
  [[nodiscard]] std::string clip(const Box& box, std::size_t number) const;
  [[nodiscard]] static std::string end_of_clip() { return "</g>"; }

 private:
  [[nodiscard]] std::string points(const std::vector<Point>& points) const;
  [[nodiscard]] std::string rectangle(const Box& box) const;

  double height_;
};

// The file: a white sheet with the elements on it, each on its line.
[[nodiscard]] std::string svg_document(int width, int height, const std::vector<std::string>& elements);

}  // namespace lrcs
