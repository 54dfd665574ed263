#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lrcs {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

[[nodiscard]] std::size_t size_in_bytes(PlyType type);
[[nodiscard]] bool is_integer(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type;                       // of the value, or of a list's items
  std::optional<PlyType> count_type;  // of a list's length; none: no list
};

struct PlyElement {
  std::string name;
  std::uint64_t count;
  std::vector<PlyProperty> properties;
  int line;  // where the header declares it
};

enum class PlyEncoding { text, little_endian, big_endian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::text;
  std::vector<PlyElement> elements;  // in file order
  std::size_t data_begin = 0;        // offset of the first byte after the header
  int data_line = 0;                 // the line that begins there
};

// Reads the header of a PLY file and checks that every element's rows can fit into the bytes after it.
// error: InputError at the line.
[[nodiscard]] PlyHeader read_ply_header(std::string_view content, const std::string& file);

}  // namespace lrcs
