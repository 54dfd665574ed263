#include "cli/font_warning.h"

#include <fmt/format.h>

#include "view/text_bitmap.h"

namespace lrcs {

void warn_of_letters_without_font(const Common& common) {
  static bool said = false;
  const std::size_t letters = letters_without_font().size();
  if (letters == 0 || said || common.quiet) return;
  said = true;
  fmt::print(stderr,
             "lrcs: warning: no installed font has {} {} of the names in the picture; drawn as <U+{:04X}>: install "
             "fonts-noto-cjk (Chinese, Japanese, Korean) or another font that has {}\n",
             letters, letters == 1 ? "letter" : "letters", static_cast<unsigned>(*letters_without_font().begin()),
             letters == 1 ? "it" : "them");
}

}  // namespace lrcs
