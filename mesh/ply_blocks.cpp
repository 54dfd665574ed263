#include "mesh/ply_blocks.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "base/large_pages.h"
#include "mesh/ply_properties.h"

namespace lrcs {
namespace {

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
struct VertexRow {
  std::array<std::size_t, 3> at{};
  std::array<PlyType, 3> type{};
  std::size_t size = 0;
};

std::optional<VertexRow> vertex_row(const PlyElement& element) {
  VertexRow layout;
  for (const PlyProperty& property : element.properties) {
    if (!is_scalar(property)) return std::nullopt;
    if (const std::size_t axis = axis_of(property, ply_position_names); axis < 3) {
      layout.at[axis] = layout.size;
      layout.type[axis] = property.type;
    }
    layout.size += size_in_bytes(property.type);
  }
  return layout;
}

bool read_vertices(BinaryPlyRows& rows, const PlyElement& element, MeshBuilder& builder) {
  const auto layout = vertex_row(element);
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

bool read_triangles(BinaryPlyRows& rows, const PlyElement& element, MeshBuilder& builder) {
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

}  // namespace

bool read_block(BinaryPlyRows& rows, const PlyElement& element, MeshBuilder& builder) {
  if (element.name == "vertex") return read_vertices(rows, element, builder);
  return element.name == "face" && read_triangles(rows, element, builder);
}

}  // namespace lrcs
