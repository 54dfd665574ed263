#pragma once
#include <functional>
#include <string>
#include <vector>

#include "view/canvas.h"
#include "view/decibel_cut.h"
#include "view/plot_header.h"

namespace lrcs {

// What Cartesian and polar cuts share: cuts made ready, the range they span, the header that says so.
struct CutDrawing {
  std::vector<std::vector<CutPoint>> cuts;  // one a curve
  DecibelRange range;
  PlotHeader header;
};

// domain: as draw_sweep_plot. `least_span`: of the dBsm axis [dB]. `length`: of that axis, about [pixel]: a curve's
// band stays if it shows somewhere beside a thin line, which all curves then get; else its points have none.
[[nodiscard]] CutDrawing cut_drawing(const std::vector<Curve>& curves, const PlotText& text, double least_span,
                                     double length);

// Where a direction lies on the canvas.
using CutMap = std::function<Point(const CutPoint&)>;

// Draws the bands of all curves, for the curves to lie over. What is below the floor ends there.
void draw_bands(Canvas& canvas, const CutDrawing& drawing, const CutMap& map, bool straight);

// Draws all curves, first on top, with dots where directions are few. `straight`: the map takes straight lines to
// straight lines; else lines are bent in steps of a degree.
void draw_curves(Canvas& canvas, const CutDrawing& drawing, const CutMap& map, bool straight);

// Ticks from the floor up where the curves lie below it.
void draw_floor_ticks(Canvas& canvas, const CutDrawing& drawing, const CutMap& map);

}  // namespace lrcs
