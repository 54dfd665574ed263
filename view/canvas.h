#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "view/colour.h"
#include "view/png.h"
#include "view/text_bitmap.h"
#include "view/tiles.h"

class vtkAlgorithm;
class vtkScalarsToColors;

namespace lrcs {

// A place on a canvas [pixel]: x right, y up, from the lower left corner of the lower left pixel.
struct Point {
  double x = 0.0;
  double y = 0.0;
};

struct Box {
  Point low;
  Point high;
};

// How a line is drawn. `dash`: lengths of ink and of gap, in turn [pixel]; empty: solid.
struct Pen {
  Colour colour = ink;
  double width = 1.0;  // [pixel]
  std::vector<double> dash = {};
};

// Which point of the text lies on the anchor. y: `middle` is the middle of a capital letter, `baseline` the line that
// letters stand on.
enum class AlignX { left, centre, right };
enum class AlignY { top, middle, baseline };

struct TextStyle {
  Font font = {36, false};
  Colour colour = ink;
  AlignX x = AlignX::left;
  AlignY y = AlignY::baseline;
  bool upward = false;  // turned by 90 degrees, to be read from below upward; x and y stay those of the text itself
  double halo = 0.0;    // opacity of the white ground behind the text [1]
};

// Whether a canvas keeps its shapes too, for SVG.
enum class Recording { none, shapes };

// A white sheet on which VTK's image filters draw plots: no display, no graphics driver.
// value: every shape covers a pixel by the share of it that lies inside (smooth edges); later shapes lie over earlier.
// domain: shapes may lie anywhere; what is outside the sheet (or the clip box) is not drawn. A line breaks where a
// point is not finite.
// laws: the same calls give the same picture, on any machine with the same VTK, FreeType and, where text has letters
//   that VTK's face lacks, fonts.
// error: one level a shape where it mixes with what lies below.
// check: tests/view/canvas_test.cpp measures areas of ink.
class Canvas {
 public:
  // magnification: pixels of the picture for each that shapes are given in: all of a plot grows with its picture.
  // throws std::invalid_argument unless all are positive
  Canvas(int width, int height, Recording recording = Recording::none, double magnification = 1.0);
  explicit Canvas(Picture ground);

  // Of the sheet, as shapes see it.
  [[nodiscard]] double width() const { return sheet_.width / magnification_; }
  [[nodiscard]] double height() const { return sheet_.height / magnification_; }

  void clip(const Box& box);
  void no_clip();

  void fill(const Box& box, const Colour& colour, double opacity = 1.0);
  // Through the points in order, with round joins and ends. error: 2 % of the inked area.
  void line(const std::vector<Point>& points, const Pen& pen);
  // Many solid lines as one shape, `dash` unused: faster than one by one.
  void strokes(const std::vector<std::vector<Point>>& strokes, const Pen& pen);
  void frame(const Box& box, const Pen& pen);
  void circle(const Point& centre, double radius, const Pen& pen);
  void disc(const Point& centre, double radius, const Colour& colour);
  // A filled polygon through which what is below shines. shape: as Tile::outline.
  void area(const std::vector<Point>& outline, const Colour& colour, double opacity);
  // Filled polygons, later ones over earlier ones, without seams between neighbours: see view/tiles.h.
  void tiles(const std::vector<Tile>& tiles);
  // Another picture over this one, its lower left pixel at (left, bottom); what lies outside the clip box is left out.
  // domain: a canvas that magnifies nothing.
  void paste(const Picture& picture, int left, int bottom);
  void text(const Point& anchor, const std::string& text, const TextStyle& style);

  [[nodiscard]] const Picture& picture() const { return sheet_; }
  // The shapes so far as an SVG file. domain: a canvas that records them; else std::logic_error.
  [[nodiscard]] std::string svg() const;

 private:
  struct Pixels {  // columns and rows [low, high)
    int left, bottom, right, top;
    [[nodiscard]] bool empty() const { return left >= right || bottom >= top; }
  };
  // What is given, in pixels of the sheet.
  [[nodiscard]] Point on_sheet(const Point& p) const { return {magnification_ * p.x, magnification_ * p.y}; }
  [[nodiscard]] Box on_sheet(const Box& box) const { return {on_sheet(box.low), on_sheet(box.high)}; }
  [[nodiscard]] Pen on_sheet(Pen pen) const;
  [[nodiscard]] std::vector<Point> on_sheet(std::vector<Point> points) const;
  template <class Shape>  // what it gives of an SvgElements
  void record(const Shape& shape);
  [[nodiscard]] Pixels pixels_of(const Box& box) const;
  void fill_pixels(const Box& box, const Colour& colour, double opacity);
  void blend(int column, int row, const Colour& colour, double opacity);
  void ink_lines(const std::vector<std::vector<Point>>& lines, const Pen& pen);
  void lay(vtkAlgorithm* mask, int left, int bottom, const Pixels& area, vtkScalarsToColors* inks);

  Picture sheet_;
  double magnification_ = 1.0;
  Box clip_;  // [pixel of the sheet]
  Recording recording_ = Recording::none;
  std::vector<std::string> elements_;  // of SVG (view/svg.h)
  std::size_t clips_ = 0;              // recorded so far
  bool in_clip_ = false;               // the last one is not ended
};

// Room that a text takes: width, and height from the baseline to the top of a capital [pixel].
struct TextSize {
  double width = 0.0;
  double height = 0.0;
};
[[nodiscard]] TextSize text_size(const std::string& text, const Font& font);

// The font, made smaller until the text is no wider than `room` [pixel]; not below half its size.
[[nodiscard]] Font fitting(const std::string& text, Font font, double room);

}  // namespace lrcs
