#pragma once
#include <string>

#include "view/canvas.h"

namespace lrcs {

// The text, or its end behind three dots where it is wider than the room [pixel]: the end of a path is what tells parts
// apart.
[[nodiscard]] std::string shortened(const std::string& text, const Font& font, double room);

}  // namespace lrcs
