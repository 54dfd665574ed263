#pragma once
#include "view/canvas.h"
#include "view/facet_colours.h"

namespace lrcs {

// What colours of facets mean: an upright bar with marks and labels, its limits among them, to its right and its title
// to its left, or a list of names; and the grey of what is not lit and seen.
// room: for labels and names, from a little left of the bar on [pixel].
void draw_scale(Canvas& canvas, const Box& bar, double room, const ColourScale& scale, const Font& font);

}  // namespace lrcs
