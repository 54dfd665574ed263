#include "lrcs/row_rays.h"

#include <algorithm>

#include "lrcs/embree_scene.h"
#include "lrcs/placement.h"

namespace lrcs {
namespace {

constexpr std::size_t width = RowRays::width;
static_assert(width == packet_width);
constexpr double before = 0.1;  // how far before the target rays start

void start(RTCRay16& ray, std::size_t k, const Vec3& from) {
  ray.org_x[k] = static_cast<float>(from.x());
  ray.org_y[k] = static_cast<float>(from.y());
  ray.org_z[k] = static_cast<float>(from.z());
  ray.tfar[k] = std::numeric_limits<float>::infinity();
}

}  // namespace

struct RowRays::Packet {
  alignas(64) RTCRayHit16 hits;
  alignas(64) RTCRay16 shadow;
  alignas(64) std::array<int, width> valid;
  RTCIntersectContext context;
  std::array<Vec3, width> starts;
};

RowRays::RowRays(const FacetMesh& mesh, const EmbreeScene& scene)
    : mesh_(mesh), scene_(scene), packet_(std::make_unique<Packet>()) {}

RowRays::~RowRays() = default;

void RowRays::look_along(const RowGrid& grid, const Vec3& to_transmitter) {
  to_receiver_ = grid.toward;
  to_transmitter_ = to_transmitter;
  bistatic_ = to_transmitter != to_receiver_;
  from_ = grid.corner + before * grid.toward;
  along_x_ = grid.step * grid.right;
  along_y_ = grid.step * grid.up;
  aim(packet_->hits.ray, -to_receiver_);
  aim(packet_->shadow, to_transmitter_);
}

void RowRays::cast(const std::array<GridPlace, width>& places, std::size_t count, std::array<Seen, width>& seen) {
  Packet& p = *packet_;
  rtcInitIntersectContext(&p.context);
  p.context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  for (std::size_t k = 0; k < count; ++k) {
    p.starts[k] = from_ + places[k].x * along_x_ + places[k].y * along_y_;
    start(p.hits.ray, k, p.starts[k]);
    p.hits.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
    p.valid[k] = -1;
  }
  std::fill(p.valid.begin() + static_cast<std::ptrdiff_t>(count), p.valid.end(), 0);
  rtcIntersect16(p.valid.data(), scene_.scene(), &p.context, &p.hits);
  for (std::size_t k = 0; k < count; ++k) {
    const bool any = p.hits.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID;
    seen[k] = any ? Seen{p.hits.hit.primID[k], true} : Seen{};
  }
  if (bistatic_) light(count, seen);
}

void RowRays::light(std::size_t count, std::array<Seen, width>& seen) {
  Packet& p = *packet_;
  bool any = false;
  for (std::size_t k = 0; k < count; ++k) {
    p.valid[k] = 0;
    if (!seen[k].any()) continue;
    const Vec3& n = mesh_.normals[seen[k].facet];
    seen[k].lit = n.dot(to_transmitter_) * n.dot(to_receiver_) > 0.0;
    if (!seen[k].lit) continue;
    // Clear of the facet itself.
    const double side = n.dot(to_transmitter_) > 0.0 ? float_error : -float_error;
    start(p.shadow, k, p.starts[k] - static_cast<double>(p.hits.ray.tfar[k]) * to_receiver_ + side * n);
    p.valid[k] = -1;
    any = true;
  }
  if (!any) return;
  rtcOccluded16(p.valid.data(), scene_.scene(), &p.context, &p.shadow);
  for (std::size_t k = 0; k < count; ++k)
    if (p.valid[k] == -1 && p.shadow.tfar[k] < 0.0F) seen[k].lit = false;
}

}  // namespace lrcs
