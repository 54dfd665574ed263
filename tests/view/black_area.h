#pragma once
#include "view/canvas.h"

namespace lrcs {

// Ink on a white sheet, in pixels fully black.
inline double black_area(const Canvas& canvas) {
  double area = 0.0;
  const Picture picture = canvas.picture();
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3) area += 1.0 - picture.rgb[i] / 255.0;
  return area;
}

}  // namespace lrcs
