#include "view/readable_text.h"

#include <gtest/gtest.h>

namespace lrcs {
namespace {

TEST(ReadableText, IsTheTextWhereThatIsUtf8) {
  for (const std::string text : {"", "panel #2", "太阳能板", "Ωмега é", "a < b", "𝄞\U0010ffff", "\u0800\ud7ff\ue000"})
    EXPECT_EQ(readable(text), text);
}

TEST(ReadableText, LeavesOutWhatHasNoShape) {
  EXPECT_EQ(readable("sat\u200b\ufe0f\u202e太\ufeff"), "sat太");
}

TEST(ReadableText, ShowsBytesThatAreNotUtf8) {
  EXPECT_EQ(readable("\xb0\xe5"), "<B0><E5>");                            // 板 in GBK
  EXPECT_EQ(readable("\xcc\xab\xd1\xf4 ²"), "<CC><AB><D1><F4> ²");        // 太阳 in GBK; cc ab alone would be UTF-8
  EXPECT_EQ(readable("caf\xe9 1"), "caf<E9> 1");                          // Latin-1
  EXPECT_EQ(readable("\xe5\xa4"), "<E5><A4>");                            // its end is missing
  EXPECT_EQ(readable("\xc0\x80 \xe0\x9f\xbf"), "<C0><80> <E0><9F><BF>");  // longer than need be
  EXPECT_EQ(readable("\xed\xa0\x80"), "<ED><A0><80>");                    // half of a pair of UTF-16
  EXPECT_EQ(readable("\xf4\x90\x80\x80\xff"), "<F4><90><80><80><FF>");    // beyond Unicode
}

TEST(ReadableText, IsOneLineThatXmlCanHold) {
  EXPECT_EQ(readable("a\tb\nc\x01"
                     "d\x7f"
                     "e\u0085f\uffff"),
            "a b c d e f ");
}

TEST(ReadableText, HasItsLettersAsCodePoints) {
  EXPECT_EQ(letters_of("aé太𝄞"), U"aé太𝄞");
}

}  // namespace
}  // namespace lrcs
