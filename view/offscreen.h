#pragma once
#include <vector>

#include "view/png.h"

class vtkRenderer;

namespace lrcs {

// Renders layers, the first lowest, without a window. error: std::runtime_error, one line, where no 3-D picture can be
// drawn (view/private_display.h).
[[nodiscard]] Picture drawn_offscreen(const std::vector<vtkRenderer*>& layers, int width, int height);

// How much finer to draw a picture, to be shrunk by that: smooth edges, whatever the driver offers.
[[nodiscard]] int offscreen_fineness(int width, int height);

}  // namespace lrcs
