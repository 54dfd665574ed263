#include <fmt/format.h>

#include <bit>
#include <cstring>

#include "base/input_error.h"
#include "mesh/file_format.h"
#include "mesh/mesh_builder.h"
#include "mesh/read_formats.h"
#include "mesh/text_scanner.h"

namespace lrcs {
namespace {

void expect(TextScanner& scanner, std::string_view keyword) {
  const std::string_view word = scanner.next_word();
  if (!same_word(word, keyword)) scanner.fail_expected(fmt::format("'{}'", keyword), word);
}

// "normal" and its three numbers may be missing or nonsense: they are not used.
void skip_normal(TextScanner& scanner) {
  std::string_view word = scanner.next_word();
  for (int k = 0; k < 4 && !same_word(word, "outer"); ++k) word = scanner.next_word();
  if (!same_word(word, "outer")) scanner.fail_expected("'outer loop'", word);
  expect(scanner, "loop");
}

// From after "facet" to after "endfacet".
void read_facet(TextScanner& scanner, MeshBuilder& builder, std::vector<std::uint32_t>& corners) {
  skip_normal(scanner);
  corners.clear();
  std::string_view word = scanner.next_word();
  for (; same_word(word, "vertex"); word = scanner.next_word()) {
    const double x = scanner.coordinate();
    const double y = scanner.coordinate();
    corners.push_back(builder.add_position({x, y, scanner.coordinate()}));
  }
  if (!same_word(word, "endloop")) scanner.fail_expected("'vertex' or 'endloop'", word);
  if (corners.size() < 3) scanner.fail(fmt::format("expected at least 3 vertices, found {}", corners.size()));
  builder.add_polygon(corners);
  expect(scanner, "endfacet");
}

float float_at(std::string_view content, std::size_t at) {
  std::uint32_t bits = 0;
  for (std::size_t k = 4; k-- > 0;) bits = bits << 8U | static_cast<unsigned char>(content[at + k]);
  return std::bit_cast<float>(bits);
}

Vec3 vertex_at(std::string_view content, std::size_t at) {
  return {float_at(content, at), float_at(content, at + 4), float_at(content, at + 8)};
}

}  // namespace

FacetMesh read_text_stl(std::string_view content, const std::string& file) {
  TextScanner scanner(content, file);
  MeshBuilder builder;
  std::vector<std::uint32_t> corners;
  for (std::string_view word = scanner.next_word(); !word.empty(); word = scanner.next_word()) {
    if (!same_word(word, "solid")) scanner.fail_expected("'solid'", word);
    builder.begin_part(scanner.rest_of_line());
    for (word = scanner.next_word(); same_word(word, "facet"); word = scanner.next_word())
      read_facet(scanner, builder, corners);
    if (!same_word(word, "endsolid")) scanner.fail_expected("'facet' or 'endsolid'", word);
    scanner.rest_of_line();
  }
  return builder.finish();
}

FacetMesh read_binary_stl(std::string_view content, const std::string& file) {
  constexpr std::size_t header = 84;
  constexpr std::size_t record = 50;
  if (content.size() < header)
    throw InputError(Place{file},
                     fmt::format("ends after {} bytes, expected a binary STL header of 84", content.size()));
  const std::size_t count = binary_stl_count(content);
  if (content.size() != header + record * count)
    throw InputError(Place{file}, fmt::format("has {} bytes, expected {} for the {} facets of its binary STL header",
                                              content.size(), header + record * count, count));
  MeshBuilder builder;
  for (std::size_t facet = 0; facet < count; ++facet) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 p = vertex_at(content, header + record * facet + 12 * (k + 1));
      if (!p.allFinite())
        throw InputError(Place{file}, fmt::format("facet {} of {}: expected finite coordinates, found ({}, {}, {})",
                                                  facet + 1, count, p.x(), p.y(), p.z()));
      corners[k] = builder.add_position(p);
    }
    builder.add_polygon(corners);
  }
  return builder.finish();
}

}  // namespace lrcs
