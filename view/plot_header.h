#pragma once
#include <optional>
#include <string>
#include <vector>

#include "view/canvas.h"
#include "view/marker.h"

namespace lrcs {

struct LegendEntry {
  std::string label;
  Pen pen;
  std::optional<Marker> marker = {};  // on the middle of the line
  bool starts_row = false;
  bool is_area = false;  // a box of the pen's colour stands for it, instead of a line
};

// What stands above a plot, from the top: title, a note in grey (its lines one below the other), the legend in rows.
// Empty ones take no room. Title and note are wrapped between words, words that are too wide within; a title of more
// than two lines loses its middle.
struct PlotHeader {
  std::string title;
  std::string note;
  std::vector<LegendEntry> legend;
};

inline constexpr Font title_font{46, true};
inline constexpr Font axis_font{42, false};
inline constexpr Font mark_font{38, false};
inline constexpr Font note_font{32, false};

// Draws the header across the canvas, text fitted to its width. Returns the height at which it ends [pixel].
double draw_header(Canvas& canvas, const PlotHeader& header);

// The pen of curve number `curve`: the colours of curve_colour(), dashed otherwise each time they come round.
[[nodiscard]] Pen curve_pen(std::size_t curve);

}  // namespace lrcs
