#include "lrcs/row_rays.h"

#include <algorithm>

#include "lrcs/embree_scene.h"
#include "lrcs/placement.h"

namespace lrcs {
namespace {

static_assert(RowRays::width == packet_width);
constexpr double before = 0.1;  // how far before the target rays start

}  // namespace

struct RowRays::Packet {
  alignas(64) RTCRayHit16 hits;
  alignas(64) RTCRay16 shadow;
  alignas(64) std::array<int, width> valid;
  RTCIntersectContext context;
  std::uint32_t row = Seen::nothing;              // of the tiles that these are of
  std::array<std::array<double, width>, 3> from;  // where the rays of the tile at column 0 start
};

RowRays::RowRays(const FacetMesh& mesh, const EmbreeScene& scene)
    : mesh_(mesh), scene_(scene), packet_(std::make_unique<Packet>()) {}

RowRays::~RowRays() = default;

void RowRays::look_along(const RowGrid& grid, const Vec3& to_transmitter) {
  to_receiver_ = grid.toward;
  to_transmitter_ = to_transmitter;
  bistatic_ = to_transmitter != to_receiver_;
  grid_ = grid;
  packet_->row = Seen::nothing;
  rtcInitIntersectContext(&packet_->context);
  packet_->context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  aim(packet_->hits.ray, -to_receiver_);
  aim(packet_->shadow, to_transmitter_);
}

void RowRays::start_row_of_tiles(std::uint32_t row) {
  packet_->row = row;
  for (std::uint32_t k = 0; k < width; ++k) {
    const std::uint32_t of_grid = row + k / tile;
    const double x = k % tile + RowGrid::offset(of_grid), y = of_grid + 0.5;
    const Vec3 from = grid_.corner + before * grid_.toward + grid_.step * (x * grid_.right + y * grid_.up);
    for (int axis = 0; axis < 3; ++axis) packet_->from[axis][k] = from[axis];
  }
}

void RowRays::start(std::uint32_t row, std::uint32_t column) {
  Packet& p = *packet_;
  if (row != p.row) start_row_of_tiles(row);
  const Vec3 along = column * grid_.step * grid_.right;
  for (std::uint32_t k = 0; k < width; ++k) {
    p.hits.ray.org_x[k] = static_cast<float>(p.from[0][k] + along.x());
    p.hits.ray.org_y[k] = static_cast<float>(p.from[1][k] + along.y());
    p.hits.ray.org_z[k] = static_cast<float>(p.from[2][k] + along.z());
    p.hits.ray.tfar[k] = std::numeric_limits<float>::infinity();
    p.hits.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
    p.valid[k] = row + k / tile < grid_.rows && column + k % tile < grid_.columns ? -1 : 0;
  }
}

void RowRays::cast(std::uint32_t row, std::uint32_t column, std::array<Seen, width>& seen) {
  start(row, column);
  Packet& p = *packet_;
  rtcIntersect16(p.valid.data(), scene_.scene(), &p.context, &p.hits);
  for (std::size_t k = 0; k < width; ++k) {
    const bool any = p.hits.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID;
    seen[k] = any ? Seen{p.hits.hit.primID[k], true} : Seen{};
  }
  if (bistatic_) light(seen);
}

Vec3 RowRays::place(std::size_t k) const {
  const auto& ray = packet_->hits.ray;
  return Vec3(ray.org_x[k], ray.org_y[k], ray.org_z[k]) - static_cast<double>(ray.tfar[k]) * to_receiver_;
}

void RowRays::light(std::array<Seen, width>& seen) {
  Packet& p = *packet_;
  bool any = false;
  for (std::size_t k = 0; k < width; ++k) {
    p.valid[k] = 0;
    if (!seen[k].any()) continue;
    const Vec3& n = mesh_.normals[seen[k].facet];
    seen[k].lit = n.dot(to_transmitter_) * n.dot(to_receiver_) > 0.0;
    if (!seen[k].lit) continue;
    // Clear of the facet itself.
    const double side = n.dot(to_transmitter_) > 0.0 ? float_error : -float_error;
    const Vec3 from = place(k) + side * n;
    p.shadow.org_x[k] = static_cast<float>(from.x());
    p.shadow.org_y[k] = static_cast<float>(from.y());
    p.shadow.org_z[k] = static_cast<float>(from.z());
    p.shadow.tfar[k] = std::numeric_limits<float>::infinity();
    p.valid[k] = -1;
    any = true;
  }
  if (!any) return;
  rtcOccluded16(p.valid.data(), scene_.scene(), &p.context, &p.shadow);
  for (std::size_t k = 0; k < width; ++k)
    if (p.valid[k] == -1 && p.shadow.tfar[k] < 0.0F) seen[k].lit = false;
}

}  // namespace lrcs
