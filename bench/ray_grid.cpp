#include "bench/ray_grid.h"

#include <algorithm>
#include <array>
#include <limits>

namespace lrcs {
namespace {

constexpr std::uint32_t tile = 4;  // pixels along a side of what one packet holds
constexpr std::size_t width = std::size_t{tile} * tile;
static_assert(width == packet_width);

// The rays of one tile after another.
struct TileRays {
  TileRays(RTCScene scene_, const PixelGrid& grid_) : scene(scene_), grid(grid_) {
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    aim(hits.ray, -grid.toward);
    constexpr double before = 0.1;  // how far before the target rays start
    for (std::uint32_t k = 0; k < width; ++k) {
      const std::uint32_t i = k % tile, j = k / tile;
      const Vec3 middle = (i + 0.5) * grid.pixel * grid.right + (j + 0.5) * grid.pixel * grid.up;
      const Vec3 within = middle + before * grid.toward;
      within_x[k] = within.x();
      within_y[k] = within.y();
      within_z[k] = within.z();
    }
  }

  void cast(std::uint32_t column, std::uint32_t row) {
    const Vec3 from = grid.corner + column * grid.pixel * grid.right + row * grid.pixel * grid.up;
    for (std::uint32_t k = 0; k < width; ++k) {
      valid[k] = column + k % tile < grid.columns && row + k / tile < grid.rows ? -1 : 0;
      hits.ray.org_x[k] = static_cast<float>(from.x() + within_x[k]);
      hits.ray.org_y[k] = static_cast<float>(from.y() + within_y[k]);
      hits.ray.org_z[k] = static_cast<float>(from.z() + within_z[k]);
      hits.ray.tfar[k] = std::numeric_limits<float>::infinity();
      hits.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect16(valid.data(), scene, &context, &hits);
  }

  alignas(64) RTCRayHit16 hits;
  alignas(64) std::array<int, width> valid;
  RTCIntersectContext context;
  RTCScene scene;
  const PixelGrid& grid;
  std::array<double, width> within_x, within_y, within_z;  // where rays start, from the tile's corner
};

}  // namespace

RayGrid::RayGrid(const FacetMesh& mesh, const EmbreeScene& scene, const PixelGrids& grids)
    : mesh_(mesh), scene_(scene), grids_(grids), pixels_(mesh.size()) {}

void RayGrid::cast(const Vec3& to_viewer, std::uint32_t pixels) {
  std::fill(pixels_.begin(), pixels_.end(), 0U);
  grid_ = grids_.over(to_viewer, pixels);
  const FlushDenormals flush;
  TileRays rays(scene_.scene(), grid_);
  for (std::uint32_t row = 0; row < grid_.rows; row += tile)
    for (std::uint32_t column = 0; column < grid_.columns; column += tile) {
      rays.cast(column, row);
      for (std::size_t k = 0; k < width; ++k)
        if (rays.valid[k] == -1 && rays.hits.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID)
          ++pixels_[rays.hits.hit.primID[k]];
    }
}

std::vector<double> RayGrid::seen_fraction() const {
  const double side = grid_.pixel / grids_.placement().scale;
  return lrcs::seen_fraction(mesh_, pixels_, side * side, grid_.toward);
}

}  // namespace lrcs
