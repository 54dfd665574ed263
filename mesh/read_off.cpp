#include <CGAL/IO/OFF.h>
#include <CGAL/Simple_cartesian.h>
#include <fmt/format.h>

#include <sstream>

#include "base/input_error.h"
#include "base/text_scanner.h"
#include "mesh/mesh_builder.h"
#include "mesh/read_formats.h"

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

// Takes the keyword; lines before it were comments. Does it say that vertices have normals?
bool read_keyword(TextScanner& scanner) {
  const std::string_view keyword = scanner.next_word();
  if (!keyword.ends_with("OFF")) scanner.fail_expected("'OFF'", keyword);
  if (keyword.find_first_of("4n") != std::string_view::npos)
    scanner.fail(fmt::format("'{}' has more than 3 dimensions, expected OFF, COFF, NOFF or STOFF", shown(keyword)));
  TextScanner ahead = scanner;
  if (ahead.word() == "BINARY") scanner.fail("binary OFF is not read, expected OFF as text");
  return keyword.find('N') != std::string_view::npos;
}

// A count that the rest of the file can hold: every vertex and every face takes a line of two bytes or more.
std::int64_t read_count(TextScanner& scanner, std::string_view what) {
  const std::int64_t count = scanner.integer();
  if (count < 0 || count > static_cast<std::int64_t>(scanner.left() / 2))
    scanner.fail(fmt::format("{} {} do not fit into the {} bytes that follow", count, what, scanner.left()));
  return count;
}

void check_face(TextScanner& scanner, std::int64_t vertices) {
  const std::int64_t size = scanner.integer();
  if (size < 3) scanner.fail(fmt::format("expected a face of at least 3 vertices, found {}", size));
  for (std::int64_t k = 0; k < size; ++k) {
    const std::int64_t index = scanner.integer();
    if (index < 0 || index >= vertices)
      scanner.fail(fmt::format("vertex {} does not exist, expected 0 to {}", index, vertices - 1));
  }
}

void check_vertex(TextScanner& scanner) {
  for (int axis = 0; axis < 3; ++axis) coordinate(scanner);
}

// Checks a row, and adds the words checked to `text` as a line. A line end among them is one that a backslash
// continues.
template <class Check>
void copy_row(TextScanner& scanner, std::string_view content, std::string& text, const Check& check) {
  const std::size_t begin = content.size() - scanner.left();
  check(scanner);
  for (const char c : content.substr(begin, content.size() - scanner.left() - begin))
    text += c == '\\' || c == '\n' || c == '\r' ? ' ' : c;
  text += '\n';
}

// The file for CGAL, every row checked: CGAL knows neither CR as a line end nor where an error is, reads "3,5" as 3 and
// vertex 1.7 as 1, makes room for whatever number of corners is named, and misses normals that prefixes announce.
std::string checked_text(std::string_view content, const std::string& file, FileNormals* normals) {
  TextScanner scanner(content, file);
  if (!read_keyword(scanner)) normals = nullptr;
  if (line_is_used_up(scanner) && !next_used_line(scanner))
    scanner.fail("expected the numbers of vertices and faces, found the end of the file");
  const std::int64_t vertices = read_count(scanner, "vertices");
  const std::int64_t faces = read_count(scanner, "faces");
  std::string text = fmt::format("OFF {} {} 0\n", vertices, faces);
  for (std::int64_t k = 1; k <= vertices; ++k) {
    next_row(scanner, "vertex", k, vertices);
    copy_row(scanner, content, text, check_vertex);
    if (normals != nullptr) normals->add(scanner);
  }
  for (std::int64_t k = 1; k <= faces; ++k) {
    next_row(scanner, "face", k, faces);
    copy_row(scanner, content, text, [&](TextScanner& row) { check_face(row, vertices); });
  }
  return text;
}

}  // namespace

FacetMesh read_off(std::string_view content, const std::string& file, FileNormals* normals) {
  std::istringstream text(checked_text(content, file, normals));
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  std::vector<std::vector<std::uint32_t>> polygons;
  if (!CGAL::IO::read_OFF(text, points, polygons)) throw InputError(Place{file}, "cannot be read, expected OFF");
  MeshBuilder builder;
  for (const auto& p : points) builder.add_position({p.x(), p.y(), p.z()});
  for (const auto& polygon : polygons) builder.add_polygon(polygon);
  return builder.finish();
}

}  // namespace lrcs
