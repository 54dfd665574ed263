#include "bench/embree_rays.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>

#include "base/splitmix64.h"

namespace lrcs {
namespace {

// A point of the triangle (0,0), (1,0), (0,1).
struct Barycentric {
  float u, v;
};

// Point k, as if at random, evenly over the unit triangle: the square's other half is turned onto it. A short
// generator, for its time is that of the method.
Barycentric random_point(std::uint64_t k) {
  const std::uint64_t z = splitmix64(k);
  const float u = static_cast<float>(z >> 40U) * 0x1p-24F;
  const float v = static_cast<float>((z >> 16U) & 0xffffffU) * 0x1p-24F;
  return u + v > 1.0F ? Barycentric{1.0F - u, 1.0F - v} : Barycentric{u, v};
}

}  // namespace

// Rays on their way to Embree, 16 at a time.
struct EmbreeRays::Packet {
  static constexpr unsigned width = packet_width;

  Packet(RTCScene scene_, const Vec3& to_viewer, std::vector<std::uint16_t>& clear_) : scene(scene_), clear(clear_) {
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;  // up to a fifth faster here
    context.filter = skip_own_facet;
    aim(ray, to_viewer);
    std::fill_n(valid.begin(), width, -1);
  }

  void add(std::size_t facet, float x, float y, float z) {
    ray.org_x[filled] = x;
    ray.org_y[filled] = y;
    ray.org_z[filled] = z;
    ray.tfar[filled] = std::numeric_limits<float>::infinity();
    ray.id[filled] = static_cast<unsigned>(facet);
    if (++filled == width) cast();
  }

  void cast() {
    if (filled < width) std::fill(valid.begin() + filled, valid.end(), 0);
    rtcOccluded16(valid.data(), scene, &context, &ray);
    for (unsigned k = 0; k < filled; ++k) clear[ray.id[k]] += ray.tfar[k] < 0.0F ? 0 : 1;
    filled = 0;
  }

  alignas(64) RTCRay16 ray;
  alignas(64) std::array<int, width> valid;
  RTCIntersectContext context;
  RTCScene scene;
  std::vector<std::uint16_t>& clear;
  unsigned filled = 0;
};

EmbreeRays::EmbreeRays(const FacetMesh& mesh, const EmbreeScene& scene)
    : mesh_(mesh), scene_(scene), clear_(mesh.size()) {
  centroids_.reserve(3 * mesh.size());
  for (std::size_t f = 0; f < mesh.size(); ++f) {
    const auto [a, b, c] = mesh.corners(f);
    const Vec3 centroid = scene.placement().placed((a + b + c) / 3.0);
    for (int axis = 0; axis < 3; ++axis) centroids_.push_back(static_cast<float>(centroid[axis]));
  }
}

void EmbreeRays::cast(const Vec3& to_viewer, std::uint32_t strata) {
  assert(strata >= 1 && strata <= 255);
  rays_a_facet_ = strata * strata;
  std::fill(clear_.begin(), clear_.end(), std::uint16_t{0});
  const FlushDenormals flush;
  if (strata == 1)
    cast_from_centroids(to_viewer);
  else
    cast_from_strata(to_viewer, strata);
}

void EmbreeRays::cast_from_centroids(const Vec3& to_viewer) {
  Packet packet(scene_.scene(), to_viewer, clear_);
  for (std::size_t f = 0; f < mesh_.size(); ++f) {
    if (mesh_.normals[f].dot(to_viewer) <= 0.0) continue;
    packet.add(f, centroids_[3 * f], centroids_[3 * f + 1], centroids_[3 * f + 2]);
  }
  packet.cast();
}

void EmbreeRays::cast_from_strata(const Vec3& to_viewer, std::uint32_t strata) {
  Packet packet(scene_.scene(), to_viewer, clear_);
  const float step = 1.0F / static_cast<float>(strata);
  for (std::size_t f = 0; f < mesh_.size(); ++f) {
    if (mesh_.normals[f].dot(to_viewer) <= 0.0) continue;
    const auto a = scene_.corner(f, 0), b = scene_.corner(f, 1), c = scene_.corner(f, 2);
    std::uint64_t point = f << 20U;
    const auto add = [&](float u, float v) {
      u *= step;
      v *= step;
      packet.add(f, a[0] + u * (b[0] - a[0]) + v * (c[0] - a[0]), a[1] + u * (b[1] - a[1]) + v * (c[1] - a[1]),
                 a[2] + u * (b[2] - a[2]) + v * (c[2] - a[2]));
    };
    for (std::uint32_t row = 0; row < strata; ++row)
      for (std::uint32_t column = 0; column + row < strata; ++column) {
        const auto i = static_cast<float>(column), j = static_cast<float>(row);
        const Barycentric upright = random_point(++point);
        add(i + upright.u, j + upright.v);
        if (column + row + 1 == strata) continue;
        const Barycentric turned = random_point(++point);
        add(i + 1.0F - turned.u, j + 1.0F - turned.v);
      }
  }
  packet.cast();
}

std::vector<double> EmbreeRays::seen_fraction() const {
  std::vector<double> fraction(clear_.size());
  for (std::size_t f = 0; f < clear_.size(); ++f) fraction[f] = static_cast<double>(clear_[f]) / rays_a_facet_;
  return fraction;
}

}  // namespace lrcs
