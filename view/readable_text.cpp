#include "view/readable_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace lrcs {
namespace {

struct Sequence {
  char32_t letter;
  std::size_t bytes;  // 0: not UTF-8
};

// The first letter.
Sequence decoded(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text.front());
  if (lead < 0x80) return {lead, 1};
  const std::size_t bytes = lead < 0xc2 ? 0 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : lead < 0xf5 ? 4 : 0;
  if (bytes == 0 || bytes > text.size()) return {0, 0};
  char32_t letter = lead & (0x7fU >> bytes);
  for (std::size_t k = 1; k < bytes; ++k) {
    if (!continues_letter(text[k])) return {0, 0};
    letter = letter << 6U | (static_cast<unsigned char>(text[k]) & 0x3fU);
  }
  const bool overlong = (bytes == 3 && letter < 0x800) || (bytes == 4 && letter < 0x10000);
  const bool surrogate = letter >= 0xd800 && letter < 0xe000;
  return overlong || surrogate || letter > 0x10ffff ? Sequence{0, 0} : Sequence{letter, bytes};
}

// Those of ASCII and of Latin-1; and the two code points that XML refuses.
bool is_control(char32_t letter) {
  return letter < 0x20 || (letter >= 0x7f && letter < 0xa0) || letter == 0xfffe || letter == 0xffff;
}

// Those that have no shape: soft hyphen, of no width, of direction, selectors of variants, marks of byte order.
bool is_shapeless(char32_t letter) {
  return letter == 0xad || (letter >= 0x200b && letter <= 0x200f) || (letter >= 0x202a && letter <= 0x202e) ||
         (letter >= 0x2060 && letter <= 0x206f) || (letter >= 0xfe00 && letter <= 0xfe0f) || letter == 0xfeff;
}

bool is_ascii(char byte) {
  return static_cast<unsigned char>(byte) < 0x80;
}

// As much of the text as is either ASCII or not.
std::string_view first_row(std::string_view text) {
  const bool ascii = is_ascii(text.front());
  const auto other = std::find_if(text.begin(), text.end(), [&](char byte) { return is_ascii(byte) != ascii; });
  return text.substr(0, static_cast<std::size_t>(other - text.begin()));
}

std::string bytes_shown(std::string_view row) {
  std::string shown;
  for (const char byte : row) shown += fmt::format("<{:02X}>", static_cast<unsigned char>(byte));
  return shown;
}

std::string row_shown(std::string_view row) {
  std::string shown;
  for (std::string_view rest = row; !rest.empty();) {
    const auto [letter, bytes] = decoded(rest);
    if (bytes == 0) return bytes_shown(row);
    shown += is_control(letter) ? " " : is_shapeless(letter) ? "" : rest.substr(0, bytes);
    rest.remove_prefix(bytes);
  }
  return shown;
}

}  // namespace

std::string readable(const std::string& text) {
  std::string shown;
  for (std::string_view rest = text; !rest.empty();) {
    const std::string_view row = first_row(rest);
    shown += row_shown(row);
    rest.remove_prefix(row.size());
  }
  return shown;
}

std::u32string letters_of(const std::string& utf8) {
  std::u32string letters;
  for (std::string_view rest = utf8; !rest.empty();) {
    const auto [letter, bytes] = decoded(rest);
    if (bytes == 0) break;
    letters += letter;
    rest.remove_prefix(bytes);
  }
  return letters;
}

}  // namespace lrcs
