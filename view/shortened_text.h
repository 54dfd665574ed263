#pragma once
#include <string>
#include <vector>

#include "view/canvas.h"

namespace lrcs {

// The text, or its end behind three dots where it is wider than the room [pixel]: the end of a path is what tells parts
// apart.
[[nodiscard]] std::string shortened(const std::string& text, const Font& font, double room);

// Texts shortened so that those which differ still do, the first of these ways that does it: to their ends; to the ends
// of a path's steps, "…:1/…:3/bolt"; to their beginnings; the same in smaller letters, down to six tenths. Where
// none does, to their ends.
struct ShortenedTexts {
  std::vector<std::string> texts;
  Font font;
};
[[nodiscard]] ShortenedTexts shortened_apart(const std::vector<std::string>& texts, const Font& font, double room);

}  // namespace lrcs
