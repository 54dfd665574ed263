#include "lrcs/row_sums.h"

#include <algorithm>

#include "lrcs/embree_scene.h"

namespace lrcs {

RowSums::RowSums(const Target& target, const EmbreeScene& scene, const TouchingFacets& touching)
    : rays_(target.mesh, scene),
      returns_(target),
      touching_(touching),
      grazing_(target.mesh, scene.placement().scale) {}

const std::vector<RowSum>& RowSums::cast(const RowGrid& grid, const Vec3& to_transmitter) {
  const FlushDenormals flush;
  rays_.look_along(grid, to_transmitter);
  returns_.look_along(to_transmitter, grid.toward);
  grazing_.look_along(to_transmitter, grid.toward);
  bistatic_ = to_transmitter != grid.toward;
  sums_.assign(grid.rows, {});
  largest_ = 0.0;
  for (std::uint32_t row = 0; row < grid.rows; row += RowRays::tile)
    for (std::uint32_t column = 0; column < grid.columns; column += RowRays::tile) cast_tile(row, column);
  return sums_;
}

void RowSums::cast_tile(std::uint32_t row, std::uint32_t column) {
  std::array<Seen, RowRays::width> seen;
  rays_.cast(row, column, seen);
  for (std::uint32_t k = 0; k < RowRays::width; ++k) {
    if (!seen[k].any()) continue;
    RowSum& sum = sums_[row + k / RowRays::tile];
    if (const double part = bistatic_ ? grazing_.doubtful_part(seen[k].facet) : 0.0; part > 0.0)
      sum.doubt += part * returns_.most(seen[k].facet);
    if (!seen[k].lit) continue;
    const double value = returns_.of(seen[k].facet);
    largest_ = std::max(largest_, value);
    sum.value += value;
    sum.area += 1.0;
    if (touching_.any_at(seen[k].facet, rays_.place(k))) sum.doubt += returns_.range_in_plane_of(seen[k].facet);
  }
}

}  // namespace lrcs
