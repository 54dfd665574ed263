#include "bench/embree_rays.h"

#include <pmmintrin.h>
#include <xmmintrin.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "base/direction.h"

namespace lrcs::bench {
namespace {

constexpr unsigned packet = 16;
constexpr float infinity = std::numeric_limits<float>::infinity();

// Denormals off while it lives.
class NoDenormals {
 public:
  NoDenormals() {
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
  }
  ~NoDenormals() { _mm_setcsr(before_); }
  NoDenormals(const NoDenormals&) = delete;
  NoDenormals& operator=(const NoDenormals&) = delete;

 private:
  unsigned before_ = _mm_getcsr();
};

// A ray starts on its own facet, whose number is the ray's: that is no hit.
void pass_own_facet(const RTCFilterFunctionNArguments* arguments) {
  for (unsigned k = 0; k < arguments->N; ++k)
    if (RTCHitN_primID(arguments->hit, arguments->N, k) == RTCRayN_id(arguments->ray, arguments->N, k))
      arguments->valid[k] = 0;
}

// Fills a packet ray by ray and asks for it when it is full.
template <class Packet, class Ask>
class Packets {
 public:
  Packets(Packet& rays, const Vec3& direction, const Ask& ask) : rays_(rays), direction_(direction), ask_(ask) {}

  void add(const std::array<float, 3>& from, std::uint32_t id) {
    auto& r = rays_;
    r.org_x[count_] = from[0];
    r.org_y[count_] = from[1];
    r.org_z[count_] = from[2];
    r.dir_x[count_] = static_cast<float>(direction_.x());
    r.dir_y[count_] = static_cast<float>(direction_.y());
    r.dir_z[count_] = static_cast<float>(direction_.z());
    r.tnear[count_] = 0.0F;
    r.tfar[count_] = infinity;
    r.time[count_] = 0.0F;
    r.mask[count_] = ~0U;
    r.flags[count_] = 0;
    r.id[count_] = id;
    valid_[count_] = -1;
    if (++count_ == packet) flush();
  }
  void flush() {
    for (unsigned k = count_; k < packet; ++k) valid_[k] = 0;
    if (count_ > 0) ask_(valid_.data(), count_);
    count_ = 0;
  }

 private:
  Packet& rays_;
  Vec3 direction_;
  const Ask& ask_;
  alignas(64) std::array<int, packet> valid_{};
  unsigned count_ = 0;
};

}  // namespace

EmbreeRays::EmbreeRays(const FacetMesh& mesh)
    : mesh_(mesh), device_(rtcNewDevice("threads=1,set_affinity=0")), scene_(rtcNewScene(device_)) {
  Vec3 low = mesh.positions.front(), high = low;
  for (const Vec3& p : mesh.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  centre_ = 0.5 * (low + high);
  scale_ = 1.0 / (high - low).maxCoeff();
  rtcSetSceneFlags(scene_, static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
  rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
  const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* const positions = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.positions.size()));
  auto* const facets = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.size()));
  for (std::size_t k = 0; k < mesh.positions.size(); ++k)
    for (int axis = 0; axis < 3; ++axis)
      positions[3 * k + static_cast<std::size_t>(axis)] =
          static_cast<float>((mesh.positions[k][axis] - centre_[axis]) * scale_);
  for (std::size_t k = 0; k < mesh.size(); ++k) std::copy_n(mesh.facets[k].begin(), 3, facets + 3 * k);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene_);
}

EmbreeRays::~EmbreeRays() {
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

std::vector<double> EmbreeRays::from_facets(const Vec3& toward, unsigned side) const {
  const NoDenormals off;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.filter = pass_own_facet;
  const double share = 1.0 / (side * side);
  std::vector<double> seen(mesh_.size(), 0.0);
  alignas(64) RTCRay16 rays;
  const auto ask = [&](const int* valid, unsigned count) {
    rtcOccluded16(valid, scene_, &context, &rays);
    for (unsigned k = 0; k < count; ++k)
      if (rays.tfar[k] >= 0.0F) seen[rays.id[k]] += share;
  };
  Packets packets(rays, toward, ask);
  std::minstd_rand random(1);
  std::uniform_real_distribution<double> within(0.0, 1.0);
  for (std::uint32_t f = 0; f < mesh_.size(); ++f) {
    if (mesh_.normals[f].dot(toward) <= 0.0) continue;
    const auto corners = mesh_.corners(f);
    const Vec3 a = (corners[0] - centre_) * scale_, b = (corners[1] - centre_) * scale_;
    const Vec3 c = (corners[2] - centre_) * scale_;
    const auto add = [&](const Vec3& p) {
      packets.add({static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())}, f);
    };
    if (side == 1) {
      add((a + b + c) / 3.0);
      continue;
    }
    for (unsigned i = 0; i < side; ++i)
      for (unsigned j = 0; j < side; ++j) {
        const double root = std::sqrt((i + within(random)) / side), t = (j + within(random)) / side;
        add((1.0 - root) * a + root * (1.0 - t) * b + root * t * c);
      }
  }
  packets.flush();
  return seen;
}

std::vector<double> EmbreeRays::from_pixels(const Vec3& toward, unsigned side) const {
  const NoDenormals off;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  // Turned about the view: rows of pixels along a target's own axes fall into step with its edges.
  constexpr double turn_deg = 31.7;
  const auto [c, s] = cos_sin_deg(turn_deg);
  const Vec3 any = toward.unitOrthogonal();
  const Vec3 across = c * any + s * toward.cross(any), up = toward.cross(across);
  double x0 = 1.0, x1 = -1.0, y0 = 1.0, y1 = -1.0;
  for (const Vec3& p : mesh_.positions) {
    const Vec3 q = (p - centre_) * scale_;
    x0 = std::min(x0, across.dot(q));
    x1 = std::max(x1, across.dot(q));
    y0 = std::min(y0, up.dot(q));
    y1 = std::max(y1, up.dot(q));
  }
  const double width = (x1 - x0) / side, height = (y1 - y0) / side;
  std::vector<double> seen(mesh_.size(), 0.0);
  alignas(64) RTCRayHit16 rays;
  const auto ask = [&](const int* valid, unsigned count) {
    for (unsigned k = 0; k < count; ++k) rays.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect16(valid, scene_, &context, &rays);
    for (unsigned k = 0; k < count; ++k)
      if (rays.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID) seen[rays.hit.primID[k]] += 1.0;
  };
  Packets packets(rays.ray, Vec3(-toward), ask);
  // In blocks of 4 x 4, for rays side by side take the same way through the tree.
  for (unsigned block = 0; block < side * side; block += packet)
    for (unsigned k = 0; k < packet; ++k) {
      const unsigned per_row = side / 4, row = block / packet / per_row * 4 + k / 4;
      const unsigned column = block / packet % per_row * 4 + k % 4;
      const Vec3 p = 2.0 * toward + (x0 + (column + 0.5) * width) * across + (y0 + (row + 0.5) * height) * up;
      packets.add({static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())}, 0);
    }
  packets.flush();
  const double pixel = width * height / (scale_ * scale_);
  for (std::size_t f = 0; f < mesh_.size(); ++f) {
    const double whole = mesh_.areas[f] * std::abs(mesh_.normals[f].dot(toward));
    seen[f] = whole > 0.0 ? seen[f] * pixel / whole : 0.0;
  }
  return seen;
}

}  // namespace lrcs::bench
