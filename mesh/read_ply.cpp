#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/input_error.h"
#include "mesh/mesh_builder.h"
#include "mesh/ply_blocks.h"
#include "mesh/ply_header.h"
#include "mesh/ply_properties.h"
#include "mesh/ply_rows.h"
#include "mesh/polygon_words.h"
#include "mesh/read_formats.h"

namespace lrcs {
namespace {

template <class Rows>
void skip(Rows& rows, const PlyProperty& property) {
  if (!property.count_type) return rows.skip(property.type);
  for (std::int64_t left = rows.integer(*property.count_type); left > 0; --left) rows.skip(property.type);
}

// The rows of element vertex: positions, and normals where they are wanted.
class PlyVertices {
 public:
  PlyVertices(const PlyElement& element, MeshBuilder& builder, FileNormals* normals)
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
    if (const std::size_t axis = axis_of(property, ply_position_names); axis < 3)
      return {Of::position, static_cast<Eigen::Index>(axis)};
    if (const std::size_t axis = axis_of(property, ply_normal_names); axis < 3 && normals_ != nullptr)
      return {Of::normal, static_cast<Eigen::Index>(axis)};
    return {};
  }

  const PlyElement& element_;
  MeshBuilder& builder_;
  FileNormals* normals_;
  std::vector<Meaning> meanings_;  // one a property
};

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

bool fits(std::int64_t value, PlyType type) {
  const bool has_sign = type == PlyType::int8 || type == PlyType::int16 || type == PlyType::int32;
  const std::int64_t values = std::int64_t{1} << (8 * size_in_bytes(type));
  const std::int64_t low = has_sign ? -values / 2 : 0;
  return value >= low && value < low + values;
}

// The rows of element face: corners, and red, green and blue as a colour, other whole numbers as properties.
class PlyFaces {
 public:
  PlyFaces(const PlyElement& element, MeshBuilder& builder) : element_(element), builder_(builder) {
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

template <class Rows>
FacetMesh read_rows(Rows rows, const PlyHeader& header, std::size_t bytes, FileNormals* normals) {
  MeshBuilder builder;
  std::optional<PlyVertices> vertices;
  std::optional<PlyFaces> faces;
  for (const PlyElement& element : header.elements) {
    // Rows of no properties take no bytes: there may be any number of them.
    if (element.properties.empty()) continue;
    if (element.name == "vertex") vertices.emplace(element, builder, normals);
    if (element.name == "face") faces.emplace(element, builder);
    // Normals are taken up row by row.
    const bool has_wanted_normals = normals != nullptr && element.name == "vertex";
    if (!has_wanted_normals && read_block(rows, element, builder)) continue;
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
class PlySurfaceCheck {
 public:
  PlySurfaceCheck(const PlyHeader& header, const std::string& file, bool normals_wanted) : file_(file) {
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
    for (const std::string_view name : ply_position_names) require_one(element, name, "");
    if (!normals_wanted) return;
    for (const std::string_view name : ply_normal_names) require_one(element, name, " for curved: file_normals");
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
  PlySurfaceCheck(header, file, normals != nullptr);
  const std::string_view data = content.substr(header.data_begin);
  if (header.encoding == PlyEncoding::text)
    return read_rows(TextPlyRows(TextScanner(data, file, header.data_line)), header, data.size(), normals);
  return read_rows(BinaryPlyRows(data, header.encoding == PlyEncoding::big_endian, file), header, data.size(), normals);
}

}  // namespace lrcs
