#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

#include "base/input_error.h"
#include "base/large_pages.h"
#include "base/text_scanner.h"
#include "mesh/mesh_builder.h"
#include "mesh/ply_header.h"
#include "mesh/polygon_words.h"
#include "mesh/read_formats.h"

namespace lrcs {
namespace {

// The two sources of rows have the same functions: begin a row, take or pass over its next value, end it.
class TextRows {
 public:
  explicit TextRows(TextScanner scanner) : scanner_(std::move(scanner)) {}

  void begin_row(const PlyElement& element, std::uint64_t row) {
    do {
      if (TextScanner(scanner_).word().empty()) continue;
      return;
    } while (scanner_.next_line());
    scanner_.fail(fmt::format("the file ends here, expected row {} of {} of element {}", row + 1, element.count,
                              shown(element.name)));
  }
  [[nodiscard]] int line() const { return scanner_.line(); }
  double number(PlyType /*type*/) { return scanner_.number(); }
  std::int64_t integer(PlyType /*type*/) { return scanner_.integer(); }
  void skip(PlyType /*type*/) {
    if (const std::string_view word = scanner_.word(); word.empty()) scanner_.fail_expected("a value", word);
  }
  void end_row() {
    if (const std::string_view word = scanner_.word(); !word.empty())
      scanner_.fail_expected("the end of the row", word);
    scanner_.next_line();
  }
  [[noreturn]] void fail(const std::string& message) const { scanner_.fail(message); }

 private:
  TextScanner scanner_;
};

// A value of a binary file. Whole: bits of any integer type.
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

// domain: an integer type.
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

class BinaryRows {
 public:
  BinaryRows(std::string_view bytes, bool big_endian, std::string file)
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
  [[noreturn]] void fail(const std::string& message) const {
    throw InputError(Place{file_}, fmt::format("row {} of {} of element {}: {}", row_ + 1, element_->count,
                                               shown(element_->name), message));
  }

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

template <class Rows>
void skip(Rows& rows, const PlyProperty& property) {
  if (!property.count_type) return rows.skip(property.type);
  for (std::int64_t left = rows.integer(*property.count_type); left > 0; --left) rows.skip(property.type);
}

bool is_scalar(const PlyProperty& property) {
  return !property.count_type;
}

using AxisNames = std::array<std::string_view, 3>;
constexpr AxisNames position_names{"x", "y", "z"}, normal_names{"nx", "ny", "nz"};

// 0, 1 or 2: the property is a number and has the name of that axis; else 3.
std::size_t axis_of(const PlyProperty& property, const AxisNames& names) {
  if (!is_scalar(property)) return 3;
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), property.name) - names.begin());
}

// The rows of element vertex: positions, and normals where they are wanted.
class Vertices {
 public:
  Vertices(const PlyElement& element, MeshBuilder& builder, FileNormals* normals)
      : element_(element), builder_(builder), normals_(normals) {
    for (const PlyProperty& property : element.properties) meanings_.push_back(meaning_of(property));
  }

  template <class Rows>
  void read_row(Rows& rows) {
    Vec3 position = Vec3::Zero(), normal = Vec3::Zero();
    for (std::size_t k = 0; k < meanings_.size(); ++k) {
      const PlyProperty& property = element_.properties[k];
      const auto [of, axis] = meanings_[k];
      if (of == Of::nothing) {
        skip(rows, property);
        continue;
      }
      const double value = rows.number(property.type);
      if (of == Of::position && !is_coordinate(value))
        rows.fail(fmt::format("expected a coordinate of at most 1e100, found {}", value));
      (of == Of::position ? position : normal)[axis] = value;
    }
    builder_.add_position(position);
    if (normals_ != nullptr) normals_->add(normal, rows.line());
  }

 private:
  enum class Of { nothing, position, normal };
  struct Meaning {
    Of of = Of::nothing;
    Eigen::Index axis = 0;
  };

  [[nodiscard]] Meaning meaning_of(const PlyProperty& property) const {
    if (const std::size_t axis = axis_of(property, position_names); axis < 3)
      return {Of::position, static_cast<Eigen::Index>(axis)};
    if (const std::size_t axis = axis_of(property, normal_names); axis < 3 && normals_ != nullptr)
      return {Of::normal, static_cast<Eigen::Index>(axis)};
    return {};
  }

  const PlyElement& element_;
  MeshBuilder& builder_;
  FileNormals* normals_;
  std::vector<Meaning> meanings_;  // one a property
};

bool is_index_list(const PlyProperty& property) {
  return property.count_type && is_integer(property.type) &&
         (property.name == "vertex_indices" || property.name == "vertex_index");
}

template <class Rows>
void read_corners(Rows& rows, const PlyProperty& property, std::int64_t vertices, std::vector<std::uint32_t>& corners) {
  const std::int64_t size = rows.integer(*property.count_type);
  if (size < 3) rows.fail(fmt::format("expected a face of at least 3 vertices, found {}", size));
  corners.clear();
  for (std::int64_t k = 0; k < size; ++k) {
    const std::int64_t index = rows.integer(property.type);
    if (index < 0 || index >= vertices)
      rows.fail(fmt::format("vertex {} does not exist, expected 0 to {}", index, vertices - 1));
    corners.push_back(static_cast<std::uint32_t>(index));
  }
}

// What is read of a face besides its corners.
bool is_word(const PlyProperty& property) {
  return is_scalar(property) && is_integer(property.type);
}

bool fits(std::int64_t value, PlyType type) {
  const bool has_sign = type == PlyType::int8 || type == PlyType::int16 || type == PlyType::int32;
  const std::int64_t values = std::int64_t{1} << (8 * size_in_bytes(type));
  const std::int64_t low = has_sign ? -values / 2 : 0;
  return value >= low && value < low + values;
}

// The rows of element face: corners, and red, green and blue as a colour, other whole numbers as properties.
class Faces {
 public:
  Faces(const PlyElement& element, MeshBuilder& builder) : element_(element), builder_(builder) {
    coloured_ = std::all_of(channel_names.begin(), channel_names.end(), [&](std::string_view name) {
      return std::any_of(element.properties.begin(), element.properties.end(), [&](const PlyProperty& property) {
        return is_scalar(property) && property.type == PlyType::uint8 && property.name == name;
      });
    });
    words_.resize(element.properties.size());
  }

  template <class Rows>
  void read_row(Rows& rows) {
    for (std::size_t k = 0; k < words_.size(); ++k) {
      const PlyProperty& property = element_.properties[k];
      if (is_index_list(property))
        read_corners(rows, property, static_cast<std::int64_t>(builder_.position_count()), corners_);
      else if (is_word(property))
        take(rows, k);
      else
        skip(rows, property);
    }
    if (coloured_) builder_.begin_colour(fmt::format("#{:02x}{:02x}{:02x}", channels_[0], channels_[1], channels_[2]));
    builder_.add_polygon(corners_);
    ++row_;
  }

  [[nodiscard]] std::vector<FacetProperty> properties(const FacetMesh& mesh) const {
    std::vector<FacetProperty> properties;
    for (std::size_t k = 0; k < words_.size(); ++k)
      if (const PlyProperty& p = element_.properties[k]; is_word(p) && channel_of(p) == channel_names.size())
        properties.push_back({p.name, words_[k].of_facets(mesh)});
    return properties;
  }

 private:
  static constexpr std::array<std::string_view, 3> channel_names{"red", "green", "blue"};

  // One behind the last of properties that are none.
  [[nodiscard]] std::size_t channel_of(const PlyProperty& property) const {
    if (!coloured_) return channel_names.size();
    return static_cast<std::size_t>(std::find(channel_names.begin(), channel_names.end(), property.name) -
                                    channel_names.begin());
  }

  template <class Rows>
  void take(Rows& rows, std::size_t k) {
    const PlyProperty& property = element_.properties[k];
    const std::int64_t value = rows.integer(property.type);
    if (!fits(value, property.type)) rows.fail(fmt::format("{} is no value of its property's type", value));
    if (const std::size_t channel = channel_of(property); channel < channels_.size())
      channels_[channel] = value;
    else
      words_[k].set(row_, fmt::to_string(value));
  }

  const PlyElement& element_;
  MeshBuilder& builder_;
  bool coloured_ = false;
  std::array<std::int64_t, 3> channels_{};
  std::vector<PolygonWords> words_;  // one a property
  std::vector<std::uint32_t> corners_;
  std::size_t row_ = 0;
};

// Calls good(row) for all rows, several at a time, and says whether it was true of each.
template <class Good>
bool all_rows(std::size_t rows, const Good& good) {
  std::atomic<bool> all = true;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rows, 4096), [&](const auto& range) {
    bool here = true;
    for (std::size_t row = range.begin(); row < range.end() && here; ++row) here = good(row);
    if (!here) all = false;
  });
  return all;
}

// Where x, y and z stand in a row of scalars, and its size.
struct VertexLayout {
  std::array<std::size_t, 3> at{};
  std::array<PlyType, 3> type{};
  std::size_t size = 0;
};

std::optional<VertexLayout> vertex_layout(const PlyElement& element) {
  VertexLayout layout;
  for (const PlyProperty& property : element.properties) {
    if (!is_scalar(property)) return std::nullopt;
    if (const std::size_t axis = axis_of(property, position_names); axis < 3) {
      layout.at[axis] = layout.size;
      layout.type[axis] = property.type;
    }
    layout.size += size_in_bytes(property.type);
  }
  return layout;
}

// The quick ways, for rows that all have the same size. false, and nothing is taken: what is there, or what is wrong
// with it, is for the row by row way to find.
bool read_vertices_at_once(BinaryRows& rows, const PlyElement& element, MeshBuilder& builder) {
  const auto layout = vertex_layout(element);
  if (!layout || rows.bytes().size() / layout->size < element.count) return false;
  const bool big_endian = rows.big_endian();
  const char* const begin = rows.bytes().data();
  std::vector<Vec3> positions = large_vector<Vec3>(element.count);
  const bool good = all_rows(element.count, [&](std::size_t row) {
    const char* const here = begin + row * layout->size;
    for (std::size_t axis = 0; axis < 3; ++axis)
      positions[row][static_cast<Eigen::Index>(axis)] =
          number_at(here + layout->at[axis], layout->type[axis], big_endian);
    return is_coordinate(positions[row].x()) && is_coordinate(positions[row].y()) && is_coordinate(positions[row].z());
  });
  if (!good) return false;
  builder.add_positions(std::move(positions));
  rows.pass_over(element.count * layout->size);
  return true;
}

bool read_triangles_at_once(BinaryRows& rows, const PlyElement& element, MeshBuilder& builder) {
  const PlyProperty& list = element.properties.front();
  if (element.properties.size() != 1 || !is_index_list(list)) return false;
  const std::size_t head = size_in_bytes(*list.count_type), index_size = size_in_bytes(list.type);
  const std::size_t size = head + 3 * index_size;
  if (rows.bytes().size() / size < element.count) return false;
  const bool big_endian = rows.big_endian();
  const char* const begin = rows.bytes().data();
  const auto vertices = static_cast<std::int64_t>(builder.position_count());
  auto facets = large_vector<std::array<std::uint32_t, 3>>(element.count);
  // If the first row has three corners, the second begins where it is sought, and so on.
  const bool good = all_rows(element.count, [&](std::size_t row) {
    const char* const here = begin + row * size;
    bool in_range = integer_at(here, *list.count_type, big_endian) == 3;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t index = integer_at(here + head + k * index_size, list.type, big_endian);
      in_range = in_range && index >= 0 && index < vertices;
      facets[row][k] = static_cast<std::uint32_t>(index);
    }
    return in_range;
  });
  if (!good) return false;
  builder.add_triangles(std::move(facets));
  rows.pass_over(element.count * size);
  return true;
}

bool read_at_once(BinaryRows& rows, const PlyElement& element, MeshBuilder& builder) {
  if (element.name == "vertex") return read_vertices_at_once(rows, element, builder);
  return element.name == "face" && read_triangles_at_once(rows, element, builder);
}

bool read_at_once(TextRows& /*rows*/, const PlyElement& /*element*/, MeshBuilder& /*builder*/) {
  return false;
}

template <class Rows>
FacetMesh read_rows(Rows rows, const PlyHeader& header, std::size_t bytes, FileNormals* normals) {
  MeshBuilder builder;
  std::optional<Vertices> vertices;
  std::optional<Faces> faces;
  for (const PlyElement& element : header.elements) {
    // Rows of no properties take no bytes: there may be any number of them.
    if (element.properties.empty()) continue;
    if (element.name == "vertex") vertices.emplace(element, builder, normals);
    if (element.name == "face") faces.emplace(element, builder);
    // Normals are taken up row by row.
    const bool has_wanted_normals = normals != nullptr && element.name == "vertex";
    if (!has_wanted_normals && read_at_once(rows, element, builder)) continue;
    // Coordinates and corners take two bytes each and more: what the header claims beyond that cannot follow.
    const auto most = static_cast<std::size_t>(std::min<std::uint64_t>(element.count, bytes / 6));
    builder.reserve(element.name == "vertex" ? most : 0, element.name == "face" ? most : 0);
    for (std::uint64_t row = 0; row < element.count; ++row) {
      rows.begin_row(element, row);
      if (element.name == "vertex") {
        vertices->read_row(rows);
      } else if (element.name == "face") {
        faces->read_row(rows);
      } else {
        for (const PlyProperty& property : element.properties) skip(rows, property);
      }
      rows.end_row();
    }
  }
  FacetMesh mesh = builder.finish();
  mesh.properties = faces->properties(mesh);
  return mesh;
}

// The header must describe a surface before any row is read.
class SurfaceCheck {
 public:
  SurfaceCheck(const PlyHeader& header, const std::string& file, bool normals_wanted) : file_(file) {
    for (const PlyElement& element : header.elements) {
      if (element.name == "vertex") check_vertex(element, normals_wanted);
      if (element.name == "face") check_face(element);
    }
    if (faces_ == 0) fail(header.data_line - 1, "the header has no element face, expected one");
  }

 private:
  [[noreturn]] void fail(int line, const std::string& message) const { throw InputError(Place{file_, line}, message); }

  void check_vertex(const PlyElement& element, bool normals_wanted) {
    if (++vertices_ > 1) fail(element.line, "a second element vertex, expected one");
    for (const std::string_view name : position_names) require_one(element, name, "");
    if (!normals_wanted) return;
    for (const std::string_view name : normal_names) require_one(element, name, " for curved: file_normals");
  }

  void require_one(const PlyElement& element, std::string_view name, std::string_view why) const {
    const auto found = std::count_if(element.properties.begin(), element.properties.end(),
                                     [&](const PlyProperty& p) { return p.name == name && is_scalar(p); });
    if (found != 1)
      fail(element.line, fmt::format("element vertex has {} properties {}, expected one{}", found, name, why));
  }

  void check_face(const PlyElement& element) {
    if (vertices_ == 0) fail(element.line, "element face comes before element vertex, expected it after");
    if (++faces_ > 1) fail(element.line, "a second element face, expected one");
    int found = 0;
    for (const PlyProperty& p : element.properties) found += is_index_list(p) ? 1 : 0;
    if (found != 1)
      fail(element.line, fmt::format("element face has {} integer lists vertex_indices, expected one", found));
    for (const PlyProperty& p : element.properties)
      if (std::count_if(element.properties.begin(), element.properties.end(),
                        [&](const PlyProperty& other) { return is_word(other) && other.name == p.name; }) > 1)
        fail(element.line, fmt::format("element face has a property {} twice, expected once", shown(p.name)));
  }

  const std::string& file_;
  int vertices_ = 0;
  int faces_ = 0;
};

}  // namespace

FacetMesh read_ply(std::string_view content, const std::string& file, FileNormals* normals) {
  const PlyHeader header = read_ply_header(content, file);
  SurfaceCheck(header, file, normals != nullptr);
  const std::string_view data = content.substr(header.data_begin);
  if (header.encoding == PlyEncoding::text)
    return read_rows(TextRows(TextScanner(data, file, header.data_line)), header, data.size(), normals);
  return read_rows(BinaryRows(data, header.encoding == PlyEncoding::big_endian, file), header, data.size(), normals);
}

}  // namespace lrcs
