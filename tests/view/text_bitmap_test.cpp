// Letters that VTK's face lacks: from installed fonts (a Chinese one is needed here: scripts/install-deps.sh), or none.
#include "view/text_bitmap.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <fstream>

#include "png_pixels.h"
#include "view/glyph.h"

namespace lrcs {
namespace {

constexpr Font regular{36, false};

int ink_of(const TextBitmap& bitmap) {
  return static_cast<int>(
      std::count_if(bitmap.coverage.begin(), bitmap.coverage.end(), [](std::uint8_t c) { return c > 100; }));
}

// Of a row above the baseline; 0 outside.
int coverage_at(const TextBitmap& bitmap, int column, int above) {
  const int row = above + bitmap.baseline;
  if (column < 0 || column >= bitmap.width || row < 0 || row >= bitmap.height) return 0;
  return bitmap.coverage[static_cast<std::size_t>(row * bitmap.width + column)];
}

// Whether what `part` inks is inked in `whole` too, with its left edge at the column. VTK's shades differ a little.
bool is_in(const TextBitmap& whole, const TextBitmap& part, int column) {
  constexpr int shades = 40;
  for (int above = -part.baseline; above < part.height - part.baseline; ++above)
    for (int k = 0; k < part.width; ++k)
      if (coverage_at(whole, column + k, above) < coverage_at(part, k, above) - shades) return false;
  return true;
}

TEST(TextBitmap, FindsInVtksFaceLatinLettersAndNoOthers) {
  for (char32_t letter = 0x21; letter < 0x7f; ++letter) EXPECT_TRUE(is_built_in(letter)) << std::uint32_t{letter};
  for (const char32_t letter : std::u32string(U"éßőŁ°²µ−≤…")) EXPECT_TRUE(is_built_in(letter)) << std::uint32_t{letter};
  for (const char32_t letter : std::u32string(U"Ωαм太あ한→，"))
    EXPECT_FALSE(is_built_in(letter)) << std::uint32_t{letter};
}

TEST(TextBitmap, InksEveryLetterOfVtksFace) {
  for (const bool bold : {false, true})
    for (char32_t letter = 0x21; letter < 0x10000; ++letter)
      if (is_built_in(letter) && letter != 0xa0) {
        const auto glyph = glyph_of(letter, {36, bold});
        EXPECT_TRUE(glyph && glyph->width > 0 && glyph->height > 0) << std::uint32_t{letter};
      }
}

TEST(TextBitmap, InksLettersThatVtksFaceLacks) {
  for (const std::string text : {"太阳能板", "Ωмега", "太"})
    for (const bool bold : {false, true}) {
      const TextBitmap bitmap = text_bitmap(text, {36, bold});
      EXPECT_TRUE(bitmap.has_every_letter) << text;
      EXPECT_GT(ink_of(bitmap), 100) << text;
    }
  EXPECT_GT(ink_of(text_bitmap("太阳能板", {36, true})), ink_of(text_bitmap("太阳能板", regular)));
  EXPECT_NE(text_bitmap("太阳能板", regular).coverage, text_bitmap("大阳能板", regular).coverage);
}

TEST(TextBitmap, MixesFacesOnOneLine) {
  const TextBitmap mixed = text_bitmap("panel 太阳能板 #2", regular), latin = text_bitmap("panel", regular);
  EXPECT_EQ(mixed.capital, latin.capital);
  EXPECT_TRUE(is_in(mixed, latin, 0));
  int pen = 0;
  for (const char letter : std::string("panel ")) pen += glyph_of(static_cast<char32_t>(letter), regular)->advance;
  EXPECT_TRUE(is_in(mixed, text_bitmap("太阳能板", regular), pen));
  EXPECT_FALSE(is_in(mixed, text_bitmap("太阳能板", regular), 0));
}

TEST(TextBitmap, TakesTextThatIsNotUtf8) {
  EXPECT_EQ(text_bitmap("\xb0\xe5", regular).coverage, text_bitmap("<B0><E5>", regular).coverage);
  EXPECT_EQ(text_bitmap("a\nb", regular).coverage, text_bitmap("a b", regular).coverage);
}

// Without a font; ends the process with 0 if all is as it should be.
[[noreturn]] void draw_without_fonts() {
  const auto none = scratch_file("none.conf");
  std::ofstream(none) << "<?xml version=\"1.0\"?><fontconfig></fontconfig>";
  setenv("FONTCONFIG_FILE", none.c_str(), 1);
  const TextBitmap sun = text_bitmap("太阳", regular), body = text_bitmap("本体", regular);
  const bool is_named = is_in(sun, text_bitmap("<U+592A>", regular), 0) && ink_of(sun) > 100;
  note_letters_without_font("太阳é");
  note_letters_without_font("本体");
  const bool is_told =
      !sun.has_every_letter && letters_without_font() == std::set<char32_t>{U'太', U'阳', U'本', U'体'};
  _exit(is_named && is_told && sun.coverage != body.coverage && text_bitmap("é", regular).has_every_letter ? 0 : 1);
}

TEST(TextBitmap, NamesCodePointsOfLettersThatNoFontHas) {
  exit_in_fresh_process();
  EXPECT_EXIT(draw_without_fonts(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace lrcs
