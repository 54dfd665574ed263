#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <functional>
#include <span>
#include <system_error>
#include <utility>

#include "base/input_error.h"
#include "base/large_pages.h"
#include "base/text_scanner.h"
#include "mesh/facet_crosses.h"
#include "mesh/file_format.h"
#include "mesh/mesh_builder.h"
#include "mesh/read_formats.h"
#include "mesh/weld.h"

namespace lrcs {
namespace {

constexpr std::size_t stl_header = 84;
constexpr std::size_t stl_record = 50;

void expect(TextScanner& scanner, std::string_view keyword) {
  const std::string_view word = scanner.next_word();
  if (!same_word(word, keyword)) scanner.fail_expected(fmt::format("'{}'", keyword), word);
}

double number_or_zero(std::string_view word) {
  double number = 0.0;
  const auto [end, wrong] = std::from_chars(word.data(), word.data() + word.size(), number);
  return wrong == std::errc{} && end == word.data() + word.size() && std::isfinite(number) ? number : 0.0;
}

// The facet's normal. "normal" and its three numbers may be missing or nonsense, then it is zero: what counts is the
// winding.
Vec3 read_normal(TextScanner& scanner) {
  Vec3 normal = Vec3::Zero();
  std::string_view word = scanner.next_word();
  for (int k = 0; k < 4 && !same_word(word, "outer"); ++k) {
    if (k > 0) normal[k - 1] = number_or_zero(word);
    word = scanner.next_word();
  }
  if (!same_word(word, "outer")) scanner.fail_expected("'outer loop'", word);
  expect(scanner, "loop");
  return normal;
}

bool points_back(const Vec3& normal, const Vec3& a, const Vec3& b, const Vec3& c) {
  return facet_cross(a, b, c).dot(normal) < 0.0;
}

// From after "facet" to after "endfacet". Says whether the normal points to the back.
bool read_facet(TextScanner& scanner, MeshBuilder& builder, std::vector<std::uint32_t>& corners) {
  const Vec3 normal = read_normal(scanner);
  corners.clear();
  std::string_view word = scanner.next_word();
  for (; same_word(word, "vertex"); word = scanner.next_word()) {
    const double x = coordinate(scanner);
    const double y = coordinate(scanner);
    corners.push_back(builder.add_position({x, y, coordinate(scanner)}));
  }
  if (!same_word(word, "endloop")) scanner.fail_expected("'vertex' or 'endloop'", word);
  if (corners.size() < 3) scanner.fail(fmt::format("expected at least 3 vertices, found {}", corners.size()));
  builder.add_polygon(corners);
  expect(scanner, "endfacet");
  return points_back(normal, builder.position(corners[0]), builder.position(corners[1]), builder.position(corners[2]));
}

// The files are little-endian, and so are the machines that this is for.
float float_at(std::string_view content, std::size_t at) {
  static_assert(std::endian::native == std::endian::little);
  float x = 0.0F;
  std::memcpy(&x, content.data() + at, sizeof x);
  return x;
}

// The facet's normal (0), or one of its vertices (1, 2, 3).
Vec3 record_at(std::string_view content, std::size_t facet, std::size_t place) {
  const std::size_t at = stl_header + stl_record * facet + 12 * place;
  return {float_at(content, at), float_at(content, at + 4), float_at(content, at + 8)};
}

// Three a facet.
std::vector<Vec3> vertices_of(std::string_view content, std::size_t count, const std::string& file) {
  std::vector<Vec3> vertices = large_vector<Vec3>(3 * count);
  std::atomic<bool> finite = true;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, vertices.size(), 4096), [&](const auto& range) {
    bool here = true;
    for (std::size_t k = range.begin(); k < range.end(); ++k) {
      vertices[k] = record_at(content, k / 3, k % 3 + 1);
      here = here && vertices[k].allFinite();
    }
    if (!here) finite = false;
  });
  if (finite) return vertices;
  const auto wrong = std::find_if(vertices.begin(), vertices.end(), [](const Vec3& p) { return !p.allFinite(); });
  throw InputError(Place{file},
                   fmt::format("facet {} of {}: expected finite coordinates, found ({}, {}, {})",
                               (wrong - vertices.begin()) / 3 + 1, count, wrong->x(), wrong->y(), wrong->z()));
}

std::size_t count_normals_against(std::string_view content, const std::vector<Vec3>& vertices,
                                  std::span<const std::array<std::uint32_t, 3>> facets) {
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, facets.size(), 4096), std::size_t{0},
      [&](const auto& range, std::size_t against) {
        std::vector<Vec3> cross(range.size());
        facet_crosses(vertices, facets.subspan(range.begin(), range.size()), cross);
        for (std::size_t k = 0; k < cross.size(); ++k)
          against += cross[k].dot(record_at(content, range.begin() + k, 0)) < 0.0 ? 1 : 0;
        return against;
      },
      std::plus<>());
}

}  // namespace

FacetMesh read_text_stl(std::string_view content, const std::string& file) {
  TextScanner scanner(content, file);
  MeshBuilder builder;
  std::vector<std::uint32_t> corners;
  std::size_t normals_against = 0;
  for (std::string_view word = scanner.next_word(); !word.empty(); word = scanner.next_word()) {
    if (!same_word(word, "solid")) scanner.fail_expected("'solid'", word);
    builder.begin_part(scanner.rest_of_line());
    for (word = scanner.next_word(); same_word(word, "facet"); word = scanner.next_word())
      normals_against += read_facet(scanner, builder, corners) ? 1 : 0;
    if (!same_word(word, "endsolid")) scanner.fail_expected("'facet' or 'endsolid'", word);
    scanner.rest_of_line();
  }
  FacetMesh mesh = builder.finish();
  mesh.normals_against = normals_against;
  return mesh;
}

FacetMesh read_binary_stl(std::string_view content, const std::string& file) {
  if (content.size() < stl_header)
    throw InputError(Place{file},
                     fmt::format("ends after {} bytes, expected a binary STL header of 84", content.size()));
  const std::size_t count = binary_stl_count(content);
  if (content.size() != stl_header + stl_record * count)
    throw InputError(Place{file}, fmt::format("has {} bytes, expected {} for the {} facets of its binary STL header",
                                              content.size(), stl_header + stl_record * count, count));
  std::vector<Vec3> vertices = vertices_of(content, count, file);
  const std::vector<std::uint32_t> place = keep_different(vertices);
  auto facets = large_vector<std::array<std::uint32_t, 3>>(count);
  for (std::size_t k = 0; k < count; ++k) facets[k] = {place[3 * k], place[3 * k + 1], place[3 * k + 2]};
  const std::size_t normals_against = count_normals_against(content, vertices, facets);
  MeshBuilder builder;
  builder.add_positions(std::move(vertices));
  builder.add_triangles(std::move(facets));
  FacetMesh mesh = builder.finish();
  mesh.normals_against = normals_against;
  return mesh;
}

}  // namespace lrcs
