#include <fmt/format.h>

#include "mesh/mesh_builder.h"
#include "mesh/read_formats.h"
#include "mesh/text_scanner.h"

namespace lrcs {
namespace {

bool line_is_used_up(TextScanner ahead) {
  return ahead.word().empty();
}

// Goes to the next line that has a word on it; the word is not taken. False at the end of the file.
bool next_used_line(TextScanner& scanner) {
  while (scanner.next_line()) {
    if (!line_is_used_up(scanner)) return true;
  }
  return false;
}

void next_row(TextScanner& scanner, std::string_view what, std::int64_t number, std::int64_t count) {
  if (!next_used_line(scanner))
    scanner.fail(fmt::format("expected {} {} of {}, found the end of the file", what, number, count));
}

// Takes the keyword; lines before it were comments.
void read_keyword(TextScanner& scanner) {
  const std::string_view keyword = scanner.next_word();
  if (!keyword.ends_with("OFF")) scanner.fail_expected("'OFF'", keyword);
  if (keyword.find_first_of("4n") != std::string_view::npos)
    scanner.fail(fmt::format("'{}' has more than 3 dimensions, expected OFF, COFF, NOFF or STOFF", shown(keyword)));
  TextScanner ahead = scanner;
  if (ahead.word() == "BINARY") scanner.fail("binary OFF is not read, expected OFF as text");
}

// A count that the rest of the file can hold: every vertex and every face takes a line of two bytes or more.
std::int64_t read_count(TextScanner& scanner, std::string_view what) {
  const std::int64_t count = scanner.integer();
  if (count < 0 || count > static_cast<std::int64_t>(scanner.left() / 2))
    scanner.fail(fmt::format("{} {} do not fit into the {} bytes that follow", count, what, scanner.left()));
  return count;
}

void read_vertex(TextScanner& scanner, MeshBuilder& builder) {
  const double x = scanner.coordinate();
  const double y = scanner.coordinate();
  builder.add_position({x, y, scanner.coordinate()});
}

void read_face(TextScanner& scanner, MeshBuilder& builder, std::vector<std::uint32_t>& corners) {
  const std::int64_t size = scanner.integer();
  if (size < 3) scanner.fail(fmt::format("expected a face of at least 3 vertices, found {}", size));
  const auto vertices = static_cast<std::int64_t>(builder.position_count());
  corners.clear();
  for (std::int64_t k = 0; k < size; ++k) {
    const std::int64_t index = scanner.integer();
    if (index < 0 || index >= vertices)
      scanner.fail(fmt::format("vertex {} does not exist, expected 0 to {}", index, vertices - 1));
    corners.push_back(static_cast<std::uint32_t>(index));
  }
  builder.add_polygon(corners);
}

}  // namespace

FacetMesh read_off(std::string_view content, const std::string& file) {
  TextScanner scanner(content, file);
  MeshBuilder builder;
  std::vector<std::uint32_t> corners;
  read_keyword(scanner);
  if (line_is_used_up(scanner) && !next_used_line(scanner))
    scanner.fail("expected the numbers of vertices and faces, found the end of the file");
  const std::int64_t vertices = read_count(scanner, "vertices");
  const std::int64_t faces = read_count(scanner, "faces");
  for (std::int64_t k = 1; k <= vertices; ++k) {
    next_row(scanner, "vertex", k, vertices);
    read_vertex(scanner, builder);
  }
  for (std::int64_t k = 1; k <= faces; ++k) {
    next_row(scanner, "face", k, faces);
    read_face(scanner, builder, corners);
  }
  return builder.finish();
}

}  // namespace lrcs
