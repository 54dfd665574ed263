#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <utility>

#include "base/text_scanner.h"
#include "mesh/mesh_builder.h"
#include "mesh/mtl_colours.h"
#include "mesh/read_formats.h"

namespace lrcs {
namespace {

// Faces may come before their vertices and the colours of their materials, so these are read first.
void read_vertices(TextScanner scanner, MeshBuilder& builder, MtlColours& colours, FileNormals* normals) {
  do {
    const std::string_view keyword = scanner.word();
    if (keyword == "mtllib") colours.add_libraries(scanner.rest_of_line());
    if (keyword == "vn" && normals != nullptr) normals->add(scanner);
    if (keyword != "v") continue;
    const double x = coordinate(scanner);
    const double y = coordinate(scanner);
    builder.add_position({x, y, coordinate(scanner)});
  } while (scanner.next_line());
}

// What numbers in faces count: vertices, or normals.
struct Counted {
  std::string_view name;
  std::int64_t all;
  std::int64_t before = 0;  // above this line
};

// The number that a word is, or begins with before a slash; counted from 0.
std::uint32_t number_of(const TextScanner& scanner, std::string_view word, const Counted& counted) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || (end != word.data() + word.size() && *end != '/'))
    scanner.fail_expected(fmt::format("a {} number", counted.name), word);
  if (number == 0) scanner.fail(fmt::format("{} 0 does not exist, expected numbers from 1", counted.name));
  const std::int64_t absolute = number > 0 ? number - 1 : counted.before + number;
  if (absolute < 0 || absolute >= counted.all)
    scanner.fail(fmt::format("{} {} does not exist, the file has {}", counted.name, number,
                             number > 0 ? counted.all : counted.before));
  return static_cast<std::uint32_t>(absolute);
}

// Behind the second slash: of "7//3" or "-1/2/3".
std::string_view normal_word(const TextScanner& scanner, std::string_view word) {
  const std::size_t slash = word.find('/', std::min(word.find('/'), word.size() - 1) + 1);
  const std::string_view normal = slash < word.size() ? word.substr(slash + 1) : "";
  if (normal.empty() || normal.find('/') != std::string_view::npos)
    scanner.fail_expected("a vertex with its normal, v//vn or v/vt/vn", word);
  return normal;
}

class Faces {
 public:
  Faces(TextScanner scanner, MeshBuilder& builder, const MtlColours& colours, FileNormals* normals)
      : scanner_(std::move(scanner)),
        builder_(builder),
        colours_(colours),
        normals_(normals),
        vertices_{"vertex", static_cast<std::int64_t>(builder.position_count())},
        counted_normals_{"normal", static_cast<std::int64_t>(normals != nullptr ? normals->size() : 0)} {}

  void read() {
    do {
      read_statement(scanner_.word());
    } while (scanner_.next_line());
  }

 private:
  void read_statement(std::string_view keyword) {
    if (keyword == "v") ++vertices_.before;
    if (keyword == "vn") ++counted_normals_.before;
    if (keyword == "f") read_face();
    if (keyword == "o" || keyword == "g") builder_.begin_part(scanner_.rest_of_line());
    if (keyword == "usemtl") begin_material(scanner_.rest_of_line());
  }

  void begin_material(std::string_view name) {
    builder_.begin_material(name);
    builder_.begin_colour(colours_.of(name));
  }

  void read_face() {
    corners_.clear();
    normals_at_corners_.clear();
    std::string_view word = scanner_.word();
    for (; !word.empty(); word = scanner_.word()) {
      corners_.push_back(number_of(scanner_, word, vertices_));
      if (normals_ != nullptr)
        normals_at_corners_.push_back(number_of(scanner_, normal_word(scanner_, word), counted_normals_));
    }
    if (corners_.size() < 3) scanner_.fail(fmt::format("expected at least 3 vertices, found {}", corners_.size()));
    builder_.add_polygon(corners_);
    if (normals_ != nullptr && !normals_->add_polygon(corners_, normals_at_corners_, builder_.last_polygon()))
      scanner_.fail("the face passes a vertex twice with two normals, expected one normal there");
  }

  TextScanner scanner_;
  MeshBuilder& builder_;
  const MtlColours& colours_;
  FileNormals* normals_;
  std::vector<std::uint32_t> corners_, normals_at_corners_;
  Counted vertices_, counted_normals_;
};

}  // namespace

FacetMesh read_obj(std::string_view content, const std::string& file, std::vector<std::string>* warnings,
                   FileNormals* normals) {
  const TextScanner scanner(content, file);
  MeshBuilder builder;
  MtlColours colours(std::filesystem::path(file).parent_path(), warnings);
  read_vertices(scanner, builder, colours, normals);
  Faces(scanner, builder, colours, normals).read();
  return builder.finish();
}

}  // namespace lrcs
