#include <fmt/format.h>

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
void read_vertices(TextScanner scanner, MeshBuilder& builder, MtlColours& colours) {
  do {
    const std::string_view keyword = scanner.word();
    if (keyword == "mtllib") colours.add_libraries(scanner.rest_of_line());
    if (keyword != "v") continue;
    const double x = coordinate(scanner);
    const double y = coordinate(scanner);
    builder.add_position({x, y, coordinate(scanner)});
  } while (scanner.next_line());
}

// The vertex of "7", "7/1", "7//3" or "-1/2/3".
std::uint32_t vertex_index(const TextScanner& scanner, std::string_view word, std::int64_t before, std::int64_t all) {
  std::int64_t index = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
  if (error != std::errc() || (end != word.data() + word.size() && *end != '/'))
    scanner.fail_expected("a vertex number", word);
  if (index == 0) scanner.fail("vertex 0 does not exist, expected numbers from 1");
  const std::int64_t absolute = index > 0 ? index - 1 : before + index;
  if (absolute < 0 || absolute >= all)
    scanner.fail(fmt::format("vertex {} does not exist, the file has {}", index, index > 0 ? all : before));
  return static_cast<std::uint32_t>(absolute);
}

class Faces {
 public:
  Faces(TextScanner scanner, MeshBuilder& builder, const MtlColours& colours)
      : scanner_(std::move(scanner)),
        builder_(builder),
        colours_(colours),
        all_(static_cast<std::int64_t>(builder.position_count())) {}

  void read() {
    do {
      read_statement(scanner_.word());
    } while (scanner_.next_line());
  }

 private:
  void read_statement(std::string_view keyword) {
    if (keyword == "v") ++before_;
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
    std::string_view word = scanner_.word();
    for (; !word.empty(); word = scanner_.word()) corners_.push_back(vertex_index(scanner_, word, before_, all_));
    if (corners_.size() < 3) scanner_.fail(fmt::format("expected at least 3 vertices, found {}", corners_.size()));
    builder_.add_polygon(corners_);
  }

  TextScanner scanner_;
  MeshBuilder& builder_;
  const MtlColours& colours_;
  std::vector<std::uint32_t> corners_;
  std::int64_t before_ = 0;  // vertices above this line
  std::int64_t all_;
};

}  // namespace

FacetMesh read_obj(std::string_view content, const std::string& file, std::vector<std::string>* warnings) {
  const TextScanner scanner(content, file);
  MeshBuilder builder;
  MtlColours colours(std::filesystem::path(file).parent_path(), warnings);
  read_vertices(scanner, builder, colours);
  Faces(scanner, builder, colours).read();
  return builder.finish();
}

}  // namespace lrcs
