#pragma once
#include <optional>
#include <string>

namespace lrcs {

struct InstalledFont {
  std::string file;
  long face = 0;  // of a collection, .ttc
  bool bold = false;
};

// The font of this machine that has the letter, as fontconfig ranks them: nearest to Arial first, then those for
// simplified Chinese; bold ones first where a bold one is wanted.
// domain: outline fonts; one of coloured pictures is none.
// laws: the same answer in every locale.
[[nodiscard]] std::optional<InstalledFont> installed_font(char32_t letter, bool bold);

}  // namespace lrcs
