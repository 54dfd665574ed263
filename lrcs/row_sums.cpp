#include "lrcs/row_sums.h"

#include <algorithm>

#include "lrcs/embree_scene.h"

namespace lrcs {
namespace {

constexpr std::uint32_t tile = 4;  // rows and places of what one packet holds
static_assert(std::size_t{tile} * tile == RowRays::width);
constexpr std::size_t known_facets = 1024;

}  // namespace

RowSums::RowSums(const Target& target, const EmbreeScene& scene, const TouchingFacets& touching)
    : rays_(target.mesh, scene), returns_(target), touching_(touching), known_(known_facets) {}

const std::vector<RowSum>& RowSums::cast(const RowGrid& grid, const Vec3& to_transmitter) {
  const FlushDenormals flush;
  rays_.look_along(grid, to_transmitter);
  returns_.look_along(to_transmitter, grid.toward);
  std::fill(known_.begin(), known_.end(), Known{});
  sums_.assign(grid.rows, {});
  largest_ = 0.0;
  for (std::uint32_t row = 0; row < grid.rows; row += tile)
    for (std::uint32_t column = 0; column < grid.columns; column += tile) cast_tile(grid, row, column);
  return sums_;
}

void RowSums::cast_tile(const RowGrid& grid, std::uint32_t row, std::uint32_t column) {
  std::array<GridPlace, RowRays::width> places;
  std::array<std::uint32_t, RowRays::width> rows{};
  std::array<Seen, RowRays::width> seen;
  std::size_t count = 0;
  for (std::uint32_t r = row; r < std::min(row + tile, grid.rows); ++r)
    for (std::uint32_t c = column; c < std::min(column + tile, grid.columns); ++c) {
      places[count] = {c + grid.offset(r), r + 0.5};
      rows[count++] = r;
    }
  rays_.cast(places, count, seen);
  for (std::size_t k = 0; k < count; ++k) {
    if (!seen[k].lit) continue;
    const Known& facet = known(seen[k].facet);
    largest_ = std::max(largest_, facet.value);
    RowSum& sum = sums_[rows[k]];
    sum.value += facet.value;
    sum.area += 1.0;
    sum.doubt += facet.doubt;
  }
}

const RowSums::Known& RowSums::known(std::uint32_t facet) {
  Known& known = known_[facet % known_facets];
  if (known.facet != facet)
    known = {facet, returns_.of(facet), touching_.any(facet) ? returns_.range_in_plane_of(facet) : 0.0};
  return known;
}

}  // namespace lrcs
