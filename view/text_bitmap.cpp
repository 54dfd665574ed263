#include "view/text_bitmap.h"

// VTK 9.1 deprecates the overloads with vtkUnicodeString, but those with vtkStdString lose every letter outside ASCII.
#define VTK_DEPRECATION_LEVEL 0
#include <vtkFreeTypeTools.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkTextProperty.h>
#include <vtkUnicodeString.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "view/glyph.h"
#include "view/installed_font.h"
#include "view/readable_text.h"

namespace lrcs {
namespace {

void apply(const Font& font, vtkTextProperty* property) {
  property->SetFontFamilyToArial();
  property->SetFontSize(font.size);
  property->SetBold(font.bold ? 1 : 0);
  property->SetColor(1.0, 1.0, 1.0);
  property->SetJustificationToLeft();
  property->SetVerticalJustificationToBottom();
}

TextBitmap letters(const std::string& text, const Font& font) {
  constexpr int pixels_per_inch = 72;  // one point is one pixel
  vtkNew<vtkTextProperty> property;
  apply(font, property);
  vtkFreeTypeTools* tools = vtkFreeTypeTools::GetInstance();
  tools->ScaleToPowerTwoOff();
  vtkNew<vtkImageData> image;
  if (!tools->RenderString(property, vtkUnicodeString::from_utf8(text), pixels_per_inch, image.Get())) {
    throw std::runtime_error("the text '" + text + "' cannot be drawn");
  }
  std::array<int, 6> extent{};
  image->GetExtent(extent.data());
  TextBitmap bitmap{extent[1] - extent[0] + 1, extent[3] - extent[2] + 1, 0, 0, {}, true};
  const auto* texels = static_cast<const std::uint8_t*>(image->GetScalarPointer());
  for (vtkIdType texel = 0; texel < image->GetNumberOfPoints(); ++texel) {
    bitmap.coverage.push_back(texels[4 * texel + 3]);
  }
  return bitmap;
}

int rows_below_ink(const TextBitmap& bitmap) {
  const auto inked = std::find_if(bitmap.coverage.begin(), bitmap.coverage.end(),
                                  [](std::uint8_t coverage) { return coverage > 127; });
  return bitmap.width > 0 ? static_cast<int>(inked - bitmap.coverage.begin()) / bitmap.width : 0;
}

std::set<char32_t>& without_font() {
  static std::set<char32_t> letters;
  return letters;
}

// The letter's, or those of <U+592A>.
std::vector<Glyph> glyphs_of(char32_t letter, const Font& font) {
  if (auto glyph = glyph_of(letter, font)) return {*std::move(glyph)};
  std::vector<Glyph> glyphs;
  for (const char sign : fmt::format("<U+{:04X}>", static_cast<std::uint32_t>(letter)))
    glyphs.push_back(glyph_of(static_cast<char32_t>(sign), font).value());
  return glyphs;
}

// Side by side on one line. `line`: a text of VTK's, whose rows this one has at least.
TextBitmap joined(const std::vector<Glyph>& glyphs, const TextBitmap& line) {
  int left = 0, right = 0, bottom = -line.baseline, top = line.capital, pen = 0;
  for (const Glyph& glyph : glyphs) {
    left = std::min(left, pen + glyph.left);
    right = std::max({right, pen + glyph.left + glyph.width, pen + glyph.advance});
    bottom = std::min(bottom, glyph.top - glyph.height);
    top = std::max(top, glyph.top);
    pen += glyph.advance;
  }
  TextBitmap bitmap{right - left, top - bottom, -bottom, line.capital, {}, true};
  bitmap.coverage.resize(static_cast<std::size_t>(bitmap.width) * static_cast<std::size_t>(bitmap.height));
  pen = -left;
  for (const Glyph& glyph : glyphs) {
    for (int k = 0; k < glyph.width * glyph.height; ++k) {
      const int column = pen + glyph.left + k % glyph.width, row = glyph.top - 1 - k / glyph.width - bottom;
      std::uint8_t& texel = bitmap.coverage[static_cast<std::size_t>(row) * static_cast<std::size_t>(bitmap.width) +
                                            static_cast<std::size_t>(column)];
      texel = std::max(texel, glyph.coverage[static_cast<std::size_t>(k)]);
    }
    pen += glyph.advance;
  }
  return bitmap;
}

}  // namespace

TextBitmap text_bitmap(const std::string& text, const Font& font) {
  if (text.empty()) return {};
  TextBitmap capital = letters("H", font);
  capital.baseline = rows_below_ink(capital);
  capital.capital = capital.height - capital.baseline;
  const std::string shown = readable(text);
  const std::u32string all = letters_of(shown);
  if (std::all_of(all.begin(), all.end(), is_built_in)) {
    TextBitmap bitmap = letters(shown, font);
    bitmap.baseline = capital.baseline;
    bitmap.capital = capital.capital;
    return bitmap;
  }
  std::vector<Glyph> glyphs;
  bool has_every_letter = true;
  for (const char32_t letter : all) {
    const auto more = glyphs_of(letter, font);
    has_every_letter = has_every_letter && more.size() == 1;
    glyphs.insert(glyphs.end(), more.begin(), more.end());
  }
  TextBitmap bitmap = joined(glyphs, capital);
  bitmap.has_every_letter = has_every_letter;
  return bitmap;
}

void note_letters_without_font(const std::string& text) {
  const std::u32string all = letters_of(readable(text));
  for (const char32_t letter : std::set<char32_t>(all.begin(), all.end()))
    if (!is_built_in(letter) && !installed_font(letter, false)) without_font().insert(letter);
}

const std::set<char32_t>& letters_without_font() {
  return without_font();
}

}  // namespace lrcs
