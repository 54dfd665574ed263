#include "mesh/ply_header.h"

#include <fmt/format.h>

#include <array>

#include "base/input_error.h"
#include "base/text_scanner.h"

namespace lrcs {
namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};

constexpr std::array type_names{
    TypeName{"char", PlyType::int8},      TypeName{"int8", PlyType::int8},       TypeName{"uchar", PlyType::uint8},
    TypeName{"uint8", PlyType::uint8},    TypeName{"short", PlyType::int16},     TypeName{"int16", PlyType::int16},
    TypeName{"ushort", PlyType::uint16},  TypeName{"uint16", PlyType::uint16},   TypeName{"int", PlyType::int32},
    TypeName{"int32", PlyType::int32},    TypeName{"uint", PlyType::uint32},     TypeName{"uint32", PlyType::uint32},
    TypeName{"float", PlyType::float32},  TypeName{"float32", PlyType::float32}, TypeName{"double", PlyType::float64},
    TypeName{"float64", PlyType::float64}};

PlyType read_type(TextScanner& scanner) {
  const std::string_view word = scanner.word();
  for (const TypeName& known : type_names) {
    if (known.name == word) return known.type;
  }
  scanner.fail_expected("a type: char uchar short ushort int uint float double", word);
}

PlyEncoding read_encoding(TextScanner& scanner) {
  const std::string_view word = scanner.word();
  if (word == "ascii") return PlyEncoding::text;
  if (word == "binary_little_endian") return PlyEncoding::little_endian;
  if (word == "binary_big_endian") return PlyEncoding::big_endian;
  scanner.fail_expected("ascii, binary_little_endian or binary_big_endian", word);
}

PlyElement read_element(TextScanner& scanner) {
  PlyElement element{std::string(scanner.word()), 0, {}, scanner.line()};
  const std::int64_t count = scanner.integer();
  if (count < 0) scanner.fail(fmt::format("expected a number of rows, found {}", count));
  element.count = static_cast<std::uint64_t>(count);
  return element;
}

PlyProperty read_property(TextScanner& scanner) {
  TextScanner ahead = scanner;
  std::optional<PlyType> count_type;
  if (ahead.word() == "list") {
    scanner.word();
    count_type = read_type(scanner);
    if (!is_integer(*count_type)) scanner.fail("expected an integer type for the length of a list");
  }
  const PlyType type = read_type(scanner);
  const std::string_view name = scanner.word();
  if (name.empty()) scanner.fail_expected("a property name", name);
  return {std::string(name), type, count_type};
}

// One statement of the header; false: it was the last.
bool read_statement(TextScanner& scanner, PlyHeader& header, bool& has_format) {
  const std::string_view keyword = scanner.word();
  if (keyword == "end_header") return false;
  if (keyword.empty() || keyword == "comment" || keyword == "obj_info") return true;
  if (keyword == "format") {
    header.encoding = read_encoding(scanner);
    has_format = true;
  } else if (keyword == "element") {
    header.elements.push_back(read_element(scanner));
  } else if (keyword == "property" && !header.elements.empty()) {
    header.elements.back().properties.push_back(read_property(scanner));
  } else {
    scanner.fail_expected("format, comment, element, property or end_header", keyword);
  }
  return true;
}

// The least number of bytes that a row takes: an empty list still has a length, a word has a letter and a blank.
std::size_t least_row_size(const PlyElement& element, PlyEncoding encoding) {
  if (encoding == PlyEncoding::text) return 2 * element.properties.size();
  std::size_t size = 0;
  for (const PlyProperty& property : element.properties)
    size += size_in_bytes(property.count_type ? *property.count_type : property.type);
  return size;
}

void require_room(const PlyHeader& header, std::size_t bytes, const std::string& file) {
  for (const PlyElement& element : header.elements) {
    const std::size_t row = least_row_size(element, header.encoding);
    // One byte more: the last word of a text needs no blank behind it.
    if (row > 0 && element.count > (bytes + 1) / row)
      throw InputError(Place{file, element.line},
                       fmt::format("{} rows of element {} do not fit into the {} bytes after the header", element.count,
                                   shown(element.name), bytes));
  }
}

}  // namespace

std::size_t size_in_bytes(PlyType type) {
  constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

bool is_integer(PlyType type) {
  return type != PlyType::float32 && type != PlyType::float64;
}

PlyHeader read_ply_header(std::string_view content, const std::string& file) {
  TextScanner scanner(content, file);
  PlyHeader header;
  bool has_format = false;
  do {
    if (!scanner.next_line()) scanner.fail("the header ends here, expected end_header");
  } while (read_statement(scanner, header, has_format));
  if (!has_format) scanner.fail("the header has no format line, expected 'format ascii 1.0' or a binary one");
  // No next_line() here: binary data may begin with the byte of a line end.
  scanner.rest_of_line();
  std::size_t at = content.size() - scanner.left();
  at += content.substr(at, 2) == "\r\n" ? 2 : at < content.size() ? 1 : 0;
  header.data_begin = at;
  header.data_line = scanner.line() + 1;
  require_room(header, content.size() - at, file);
  return header;
}

}  // namespace lrcs
