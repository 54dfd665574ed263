#pragma once
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace lrcs {

// Type: the sans-serif face that VTK carries inside, so that pictures need no fonts on the machine; letters that it
// lacks, as Chinese, Greek and Cyrillic ones, are taken from fonts that are installed.
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
  bool has_every_letter = true;
};

// domain: one line, from left to right; what is no UTF-8 is made readable (view/readable_text.h). A letter that no font
// has is drawn as <U+592A>, its code point.
// laws: the same text gives the same bitmap; letters of VTK's face alone, on every machine. Needs no display.
// check: tests/view/text_bitmap_test.cpp
// Not for two threads at once: VTK's cache of letters is shared.
[[nodiscard]] TextBitmap text_bitmap(const std::string& text, const Font& font);

// Keeps in mind which letters of a text that is drawn no font has.
void note_letters_without_font(const std::string& text);
// Those, of all text so far.
[[nodiscard]] const std::set<char32_t>& letters_without_font();

}  // namespace lrcs
