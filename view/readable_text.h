#pragma once
#include <string>

namespace lrcs {

// A line of text as pictures show it. Names come from files: a byte that is not UTF-8 becomes <B4>, its hexadecimal
// value; a control character becomes a space.
// laws: the result is UTF-8 and XML can hold it; text that is so already stays as it is.
// check: tests/view/readable_text_test.cpp
[[nodiscard]] std::string readable(const std::string& text);

// Its code points. domain: UTF-8.
[[nodiscard]] std::u32string letters_of(const std::string& utf8);

}  // namespace lrcs
