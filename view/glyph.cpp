#include "view/glyph.h"

#include <vtkFreeTypeTools.h>
#include <vtkNew.h>
#include <vtkTextProperty.h>
#include <vtk_freetype.h>
#include FT_FREETYPE_H
#include FT_SYNTHESIS_H

#include <array>
#include <map>
#include <stdexcept>
#include <utility>

#include "view/installed_font.h"

namespace lrcs {
namespace {

// Faces that are open, for as long as the process lives.
class Faces {
 public:
  Faces() {
    if (FT_Init_FreeType(&library_) != 0) throw std::runtime_error("FreeType cannot be started");
    for (const bool bold : {false, true}) {
      vtkNew<vtkTextProperty> property;
      property->SetFontFamilyToArial();
      property->SetBold(bold ? 1 : 0);
      if (!vtkFreeTypeTools::LookupFace(property, library_, &built_in_[bold ? 1 : 0]))
        throw std::runtime_error("VTK's face of letters cannot be read");
    }
  }
  ~Faces() { FT_Done_FreeType(library_); }  // and its faces
  Faces(const Faces&) = delete;
  Faces& operator=(const Faces&) = delete;

  [[nodiscard]] FT_Face built_in(bool bold) const { return built_in_[bold ? 1 : 0]; }

  // Null where the file cannot be read.
  FT_Face installed(const InstalledFont& font) {
    const auto [place, is_new] = installed_.try_emplace({font.file, font.face}, nullptr);
    if (is_new && FT_New_Face(library_, font.file.c_str(), font.face, &place->second) != 0) place->second = nullptr;
    return place->second;
  }

 private:
  FT_Library library_ = nullptr;
  std::array<FT_Face, 2> built_in_{};
  std::map<std::pair<std::string, long>, FT_Face> installed_;
};

Faces& faces() {
  static Faces all;
  return all;
}

std::optional<Glyph> glyph_in(FT_Face face, char32_t letter, int size, bool embolden) {
  const FT_UInt index = face == nullptr ? 0 : FT_Get_Char_Index(face, letter);
  // Small sizes of some Chinese fonts are bitmaps without shades.
  if (index == 0 || FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(size)) != 0 ||
      FT_Load_Glyph(face, index, FT_LOAD_NO_BITMAP) != 0)
    return std::nullopt;
  FT_GlyphSlot slot = face->glyph;
  if (embolden) FT_GlyphSlot_Embolden(slot);
  if (FT_Render_Glyph(slot, FT_RENDER_MODE_NORMAL) != 0) return std::nullopt;
  const FT_Bitmap& bitmap = slot->bitmap;
  Glyph glyph{slot->bitmap_left,
              slot->bitmap_top,
              static_cast<int>(bitmap.width),
              static_cast<int>(bitmap.rows),
              static_cast<int>((slot->advance.x + 32) / 64),
              {}};
  for (int row = 0; row < glyph.height; ++row) {
    const unsigned char* first = bitmap.buffer + static_cast<std::ptrdiff_t>(row) * bitmap.pitch;
    glyph.coverage.insert(glyph.coverage.end(), first, first + glyph.width);
  }
  return glyph;
}

}  // namespace

bool is_built_in(char32_t letter) {
  return FT_Get_Char_Index(faces().built_in(false), letter) != 0;
}

std::optional<Glyph> glyph_of(char32_t letter, const Font& font) {
  if (is_built_in(letter)) return glyph_in(faces().built_in(font.bold), letter, font.size, false);
  const auto installed = installed_font(letter, font.bold);
  if (!installed) return std::nullopt;
  return glyph_in(faces().installed(*installed), letter, font.size, font.bold && !installed->bold);
}

}  // namespace lrcs
