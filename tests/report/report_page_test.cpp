#include "report/report_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <openssl/evp.h>
#include <zlib.h>

namespace lrcs {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const auto from = text.find(begin) + begin.size();
  return text.substr(from, text.find(end, from) - from);
}

std::vector<std::uint8_t> unpacked(const std::string& base64, std::size_t size) {
  std::vector<std::uint8_t> packed(base64.size());
  EVP_DecodeBlock(packed.data(), reinterpret_cast<const unsigned char*>(base64.data()),
                  static_cast<int>(base64.size()));
  std::vector<std::uint8_t> bytes(size);
  uLongf length = size;
  EXPECT_EQ(uncompress(bytes.data(), &length, packed.data(), packed.size()), Z_OK);
  EXPECT_EQ(length, size);
  return bytes;
}

TEST(ReportPage, HasOnePlaceForItsNumbers) {
  const std::string page(page_template());
  const std::string marker = "<!-- lrcs:data -->";
  EXPECT_TRUE(page.starts_with("<!doctype html>") || page.starts_with("<!DOCTYPE html>")) << page.substr(0, 40);
  EXPECT_EQ(page.find(marker), page.rfind(marker));
  EXPECT_NE(page.find(marker), std::string::npos);
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
}

TEST(ReportPage, HoldsTheNumbersAsTheyWere) {
  std::vector<std::uint8_t> facets;
  for (int k = 0; k < 100000; ++k) facets.push_back(static_cast<std::uint8_t>(k * k / 7));
  const std::string page = report_page(R"({"a": 1.5})", facets);
  EXPECT_EQ(between(page, R"(id="lrcs-data">)", "</script>"), R"({"a": 1.5})");
  EXPECT_EQ(unpacked(between(page, R"(id="lrcs-facets">)", "</script>"), facets.size()), facets);
  EXPECT_THAT(page, Not(HasSubstr("<!-- lrcs:data -->")));
}

TEST(ReportPage, LetsNoNameBeginATag) {
  const std::string page = report_page(R"({"part": "</script><script>alert(1)</script><!--"})", {});
  EXPECT_THAT(page, Not(HasSubstr("alert(1)</script")));
  EXPECT_EQ(between(page, R"(id="lrcs-data">)", "</script>"),
            R"({"part": "\u003c/script>\u003cscript>alert(1)\u003c/script>\u003c!--"})");
}

}  // namespace
}  // namespace lrcs
