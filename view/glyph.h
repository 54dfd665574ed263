#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "view/text_bitmap.h"

namespace lrcs {

// One letter as coverage: 0 no ink, 255 ink. shape: width x height, rows from the top down.
// `left`, `top`: its left edge and its top, from where the pen stands on the line; `advance`: how far the pen moves on.
// [pixel]
struct Glyph {
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;
  int advance = 0;
  std::vector<std::uint8_t> coverage;
};

// Whether the face that VTK carries inside has it.
[[nodiscard]] bool is_built_in(char32_t letter);

// From VTK's face, or where that lacks the letter from an installed font (view/installed_font.h), made bold where the
// font is not. Nothing: no font has it. Not for two threads at once.
[[nodiscard]] std::optional<Glyph> glyph_of(char32_t letter, const Font& font);

}  // namespace lrcs
