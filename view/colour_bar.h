#pragma once
#include "view/cartesian_frame.h"

namespace lrcs {

// The map viridis, its low end below.
void draw_viridis(Canvas& canvas, const Box& bar);

// An upright bar of the map viridis from axis.low to axis.high, with marks and labels to its right.
void draw_colour_bar(Canvas& canvas, const Box& bar, const Axis& axis);

}  // namespace lrcs
