#pragma once
#include <string>

namespace lrcs {

// A line of text as pictures show it. Names come from files: letters beyond ASCII in a row of which some are not UTF-8
// become their bytes, <CC><AB> (of GBK some look like UTF-8 by chance); a control character becomes a space, and
// what has no shape (of no width, of direction) is left out.
// laws: the result is UTF-8 and XML can hold it; other text stays as it is.
// check: tests/view/readable_text_test.cpp
[[nodiscard]] std::string readable(const std::string& text);

// Whether the byte is a later one of a letter of UTF-8: text is not cut before it.
[[nodiscard]] inline bool continues_letter(char byte) {
  return (static_cast<unsigned char>(byte) & 0xc0U) == 0x80U;
}

// Its code points. domain: UTF-8.
[[nodiscard]] std::u32string letters_of(const std::string& utf8);

}  // namespace lrcs
