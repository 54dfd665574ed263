#pragma once
#include <array>

#include "view/canvas.h"

namespace lrcs {

// An arrow on the screen and the room that its name takes [pixel].
struct NamedArrow {
  Point tail, tip;
  double half_width = 0.0, half_height = 0.0;  // of the name
  double clearance = 0.0;                      // between the tip and the name
};

// Middles of the names of two arrows: at their tips, off both shafts, off each other, inside the frame and outside a
// box of it that is taken, as far as that is possible; over the tips of arrows that point up and under those of others
// where nothing is in the way.
[[nodiscard]] std::array<Point, 2> places_of_names(const std::array<NamedArrow, 2>& arrows, const Box& frame,
                                                   const Box& taken = {});

}  // namespace lrcs
