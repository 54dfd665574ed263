#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "view/canvas.h"
#include "view/facet_colours.h"
#include "view/facet_result.h"
#include "view/viewed_sweep.h"

namespace lrcs {

// What is to be read beside a target at one aspect.
struct AspectFacts {
  std::size_t row = 0;
  const FacetResult* result = nullptr;
  std::vector<double> part_sigma;  // [m^2]
  ColourScale scale;
  std::optional<std::uint32_t> part;  // looked at
  std::vector<std::string> picked;    // lines on what was clicked
  std::string keys;                   // a line on what may be done; ""
};

// The paper of `lrcs view`: title and sigma above, room for the target with its colour bar, the sweep's curve with a
// marker at this aspect, the strongest parts, a slider along the sweep's rows below.
// shape: width x height pixels, at least 640 x 360; letters follow the size.
class AspectSheet {
 public:
  AspectSheet(const ViewedSweep& sweep, int width, int height);

  [[nodiscard]] Picture drawn(const AspectFacts& facts);

  // Where the target is to be drawn [pixel].
  [[nodiscard]] Box target() const;
  [[nodiscard]] int letters() const;
  // What lies at a place: a row of the sweep on slider and curve, a part in the table.
  [[nodiscard]] std::optional<std::size_t> row_at(const Point& at) const;
  [[nodiscard]] std::optional<std::uint32_t> part_at(const Point& at) const;

 private:
  struct Plot {
    std::size_t cut;
    Picture picture;
    CartesianFrame frame;  // in the picture's pixels over `magnification`
    double magnification;
  };
  [[nodiscard]] Box curve_box() const;
  [[nodiscard]] Box table_box() const;
  [[nodiscard]] Box slider_box() const;
  [[nodiscard]] Font font(double size, bool bold = false) const;
  [[nodiscard]] Point on_curve(const ViewedSweep::Place& place) const;
  const Plot& plot_of(std::size_t cut);
  void draw_words(Canvas& canvas, const AspectFacts& facts) const;
  void draw_marker(Canvas& canvas, const AspectFacts& facts) const;
  void draw_table(Canvas& canvas, const AspectFacts& facts);
  void draw_slider(Canvas& canvas, const AspectFacts& facts) const;

  const ViewedSweep& sweep_;
  double width_, height_, unit_;
  std::optional<Plot> plot_;
  std::vector<std::pair<Box, std::uint32_t>> table_rows_;
};

}  // namespace lrcs
