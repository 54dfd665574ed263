#include "cli/font_warning.h"

#include <fmt/format.h>

#include <algorithm>

#include "view/text_bitmap.h"

namespace lrcs {
namespace {

// Chinese, Japanese and Korean letters, and signs of full width.
bool is_east_asian(char32_t letter) {
  return (letter >= 0x1100 && letter < 0x1200) || (letter >= 0x2e80 && letter < 0xa000) ||
         (letter >= 0xac00 && letter < 0xd800) || (letter >= 0xf900 && letter < 0xfb00) ||
         (letter >= 0xfe30 && letter < 0xfe50) || (letter >= 0xff00 && letter < 0xfff0) ||
         (letter >= 0x20000 && letter < 0x40000);
}

}  // namespace

void warn_of_letters_without_font(const Common& common) {
  static bool said = false;
  const auto& letters = letters_without_font();
  if (letters.empty() || said || common.quiet) return;
  said = true;
  const bool is_one = letters.size() == 1;
  fmt::print(stderr,
             "lrcs: warning: no installed font has {} {} of the names in the picture; drawn as <U+{:04X}>: install a "
             "font that has {}{}\n",
             letters.size(), is_one ? "letter" : "letters", static_cast<unsigned>(*letters.begin()),
             is_one ? "it" : "them",
             std::all_of(letters.begin(), letters.end(), is_east_asian) ? ", such as fonts-noto-cjk" : "");
}

}  // namespace lrcs
