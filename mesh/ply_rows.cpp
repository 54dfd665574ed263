#include "mesh/ply_rows.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>

#include "base/input_error.h"

namespace lrcs {
namespace {

// domain: Bits is an unsigned integer type.
template <class Bits>
Bits bits_at(const char* bytes, bool big_endian) {
  static_assert(std::endian::native == std::endian::little);
  Bits bits = 0;
  std::memcpy(&bits, bytes, sizeof bits);
  if (!big_endian) return bits;
  if constexpr (sizeof bits == 2) return __builtin_bswap16(bits);
  if constexpr (sizeof bits == 4) return __builtin_bswap32(bits);
  if constexpr (sizeof bits == 8) return __builtin_bswap64(bits);
  return bits;
}

}  // namespace

std::int64_t integer_at(const char* bytes, PlyType type, bool big_endian) {
  switch (type) {
    case PlyType::int8:
      return static_cast<std::int8_t>(*bytes);
    case PlyType::uint8:
      return static_cast<std::uint8_t>(*bytes);
    case PlyType::int16:
      return static_cast<std::int16_t>(bits_at<std::uint16_t>(bytes, big_endian));
    case PlyType::uint16:
      return bits_at<std::uint16_t>(bytes, big_endian);
    case PlyType::int32:
      return static_cast<std::int32_t>(bits_at<std::uint32_t>(bytes, big_endian));
    default:
      return bits_at<std::uint32_t>(bytes, big_endian);
  }
}

double number_at(const char* bytes, PlyType type, bool big_endian) {
  if (type == PlyType::float32) return std::bit_cast<float>(bits_at<std::uint32_t>(bytes, big_endian));
  if (type == PlyType::float64) return std::bit_cast<double>(bits_at<std::uint64_t>(bytes, big_endian));
  return static_cast<double>(integer_at(bytes, type, big_endian));
}

void TextPlyRows::begin_row(const PlyElement& element, std::uint64_t row) {
  do {
    if (TextScanner(scanner_).word().empty()) continue;
    return;
  } while (scanner_.next_line());
  scanner_.fail(fmt::format("the file ends here, expected row {} of {} of element {}", row + 1, element.count,
                            shown(element.name)));
}

void TextPlyRows::skip(PlyType /*type*/) {
  if (const std::string_view word = scanner_.word(); word.empty()) scanner_.fail_expected("a value", word);
}

void TextPlyRows::end_row() {
  if (const std::string_view word = scanner_.word(); !word.empty()) scanner_.fail_expected("the end of the row", word);
  scanner_.next_line();
}

void BinaryPlyRows::fail(const std::string& message) const {
  throw InputError(Place{file_}, fmt::format("row {} of {} of element {}: {}", row_ + 1, element_->count,
                                             shown(element_->name), message));
}

}  // namespace lrcs
