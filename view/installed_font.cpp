#include "view/installed_font.h"

#include <fontconfig/fontconfig.h>

#include <memory>

namespace lrcs {
namespace {

template <class T, auto destroy>
struct Destroyed {
  void operator()(T* thing) const { destroy(thing); }
};
using Config = std::unique_ptr<FcConfig, Destroyed<FcConfig, FcConfigDestroy>>;
using Pattern = std::unique_ptr<FcPattern, Destroyed<FcPattern, FcPatternDestroy>>;
using Ranking = std::unique_ptr<FcFontSet, Destroyed<FcFontSet, FcFontSetDestroy>>;

const FcChar8* words(const char* text) {
  return reinterpret_cast<const FcChar8*>(text);
}

Ranking ranked_fonts(FcConfig* config, bool bold) {
  const Pattern wanted(FcPatternCreate());
  FcPatternAddString(wanted.get(), FC_FAMILY, words("Arial"));
  // Without a language that of the locale is taken: pictures would differ from one terminal to the next.
  FcPatternAddString(wanted.get(), FC_LANG, words("zh-cn"));
  FcPatternAddInteger(wanted.get(), FC_WEIGHT, bold ? FC_WEIGHT_BOLD : FC_WEIGHT_REGULAR);
  FcConfigSubstitute(config, wanted.get(), FcMatchPattern);
  FcDefaultSubstitute(wanted.get());
  FcResult result = FcResultNoMatch;
  return Ranking(FcFontSort(config, wanted.get(), FcFalse, nullptr, &result));
}

bool is_true(const FcPattern* font, const char* property) {
  FcBool value = FcFalse;
  return FcPatternGetBool(font, property, 0, &value) == FcResultMatch && value == FcTrue;
}

bool has(const FcPattern* font, char32_t letter) {
  FcCharSet* letters = nullptr;
  return FcPatternGetCharSet(font, FC_CHARSET, 0, &letters) == FcResultMatch &&
         FcCharSetHasChar(letters, letter) == FcTrue;
}

std::optional<InstalledFont> file_of(const FcPattern* font) {
  FcChar8* file = nullptr;
  int face = 0, weight = FC_WEIGHT_REGULAR;
  if (FcPatternGetString(font, FC_FILE, 0, &file) != FcResultMatch) return std::nullopt;
  FcPatternGetInteger(font, FC_INDEX, 0, &face);
  FcPatternGetInteger(font, FC_WEIGHT, 0, &weight);
  return InstalledFont{reinterpret_cast<const char*>(file), face, weight >= FC_WEIGHT_DEMIBOLD};
}

}  // namespace

std::optional<InstalledFont> installed_font(char32_t letter, bool bold) {
  static const Config config(FcInitLoadConfigAndFonts());
  if (!config) return std::nullopt;
  static const Ranking plain_ones = ranked_fonts(config.get(), false), bold_ones = ranked_fonts(config.get(), true);
  const Ranking& ranking = bold ? bold_ones : plain_ones;
  if (!ranking) return std::nullopt;
  for (int k = 0; k < ranking->nfont; ++k) {
    const FcPattern* font = ranking->fonts[k];
    if (is_true(font, FC_OUTLINE) && !is_true(font, FC_COLOR) && has(font, letter)) return file_of(font);
  }
  return std::nullopt;
}

}  // namespace lrcs
