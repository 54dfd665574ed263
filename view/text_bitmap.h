#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace lrcs {

// Type: the sans-serif face that VTK carries inside, so that pictures need no fonts on the machine.
struct Font {
  int size = 0;  // of the em square [pixel]
  bool bold = false;
};

// A line of text as coverage: 0 no ink, 255 ink.
// shape: width x height, rows from the bottom up. `baseline`: rows below the line that the letters stand on;
// `capital`: rows from there to the top of an H. [pixel]
struct TextBitmap {
  int width = 0;
  int height = 0;
  int baseline = 0;
  int capital = 0;
  std::vector<std::uint8_t> coverage;
};

// domain: UTF-8, one line; Latin letters and common signs; the face has no Greek, and what it lacks leaves no ink.
// laws: the same text gives the same bitmap. Needs no display.
// Not for two threads at once: VTK's cache of letters is shared.
[[nodiscard]] TextBitmap text_bitmap(const std::string& text, const Font& font);

}  // namespace lrcs
