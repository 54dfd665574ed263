#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "base/text_scanner.h"
#include "mesh/ply_header.h"

namespace lrcs {

// A value of a binary file. domain: an integer type; of number_at() any type.
[[nodiscard]] std::int64_t integer_at(const char* bytes, PlyType type, bool big_endian);
[[nodiscard]] double number_at(const char* bytes, PlyType type, bool big_endian);

// The rows of a PLY file's elements, one after another, of text or of bytes: both have the same functions. Begin a row,
// take or pass over its next value, end it.
// error: InputError at the line, or the row of a binary file, where something else stands.
class TextPlyRows {
 public:
  explicit TextPlyRows(TextScanner scanner) : scanner_(std::move(scanner)) {}

  void begin_row(const PlyElement& element, std::uint64_t row);
  [[nodiscard]] int line() const { return scanner_.line(); }
  double number(PlyType /*type*/) { return scanner_.number(); }
  std::int64_t integer(PlyType /*type*/) { return scanner_.integer(); }
  void skip(PlyType type);
  void end_row();
  [[noreturn]] void fail(const std::string& message) const { scanner_.fail(message); }

 private:
  TextScanner scanner_;
};

class BinaryPlyRows {
 public:
  BinaryPlyRows(std::string_view bytes, bool big_endian, std::string file)
      : bytes_(bytes), big_endian_(big_endian), file_(std::move(file)) {}

  void begin_row(const PlyElement& element, std::uint64_t row) {
    element_ = &element;
    row_ = row;
  }
  [[nodiscard]] static int line() { return 0; }
  double number(PlyType type) { return number_at(take(size_in_bytes(type)), type, big_endian_); }
  // domain: an integer type.
  std::int64_t integer(PlyType type) { return integer_at(take(size_in_bytes(type)), type, big_endian_); }
  void skip(PlyType type) { take(size_in_bytes(type)); }
  void end_row() const {}
  [[noreturn]] void fail(const std::string& message) const;

  // What is left, and how it is to be read.
  [[nodiscard]] std::string_view bytes() const { return bytes_; }
  [[nodiscard]] bool big_endian() const { return big_endian_; }
  // domain: so many are left.
  void pass_over(std::size_t bytes) { bytes_.remove_prefix(bytes); }

 private:
  const char* take(std::size_t size) {
    if (bytes_.size() < size) fail("the file ends here");
    const char* const taken = bytes_.data();
    bytes_.remove_prefix(size);
    return taken;
  }

  std::string_view bytes_;
  bool big_endian_;
  std::string file_;
  const PlyElement* element_ = nullptr;
  std::uint64_t row_ = 0;
};

}  // namespace lrcs
