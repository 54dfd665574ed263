#include "lrcs/touching_facets.h"

#include <array>

#include "lrcs/embree_scene.h"

namespace lrcs {
namespace {

constexpr double near = 2e-6;  // of the target's size: what floats around 1 can tell, and to spare

bool is_own(RTCRayN* ray, RTCHitN* hit, unsigned count, unsigned k) {
  return RTCHitN_primID(hit, count, k) == RTCRayN_id(ray, count, k);
}

void skip_own_facet(const RTCFilterFunctionNArguments* hits) {
  for (unsigned k = 0; k < hits->N; ++k)
    if (hits->valid[k] == -1 && is_own(hits->ray, hits->hit, hits->N, k)) hits->valid[k] = 0;
}

RTCRayHit short_ray(std::uint32_t facet, const Vec3& from, const Vec3& along) {
  RTCRayHit ray{};
  ray.ray.org_x = static_cast<float>(from.x());
  ray.ray.org_y = static_cast<float>(from.y());
  ray.ray.org_z = static_cast<float>(from.z());
  ray.ray.dir_x = static_cast<float>(along.x());
  ray.ray.dir_y = static_cast<float>(along.y());
  ray.ray.dir_z = static_cast<float>(along.z());
  ray.ray.tfar = static_cast<float>(2.0 * near);
  ray.ray.mask = ~0U;
  ray.ray.id = facet;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  return ray;
}

}  // namespace

TouchingFacets::TouchingFacets(const Target& target, const EmbreeScene& scene) : mesh_(target.mesh) {
  bool one_material = true;
  for (const std::uint32_t m : target.material) one_material = one_material && m == target.material.front();
  if (one_material && target.sides == Sides::both) return;
  touched_.assign(mesh_.size(), 0);
  const FlushDenormals flush;
  for (std::uint32_t f = 0; f < mesh_.size(); ++f) probe(f, scene);
}

void TouchingFacets::probe(std::uint32_t facet, const EmbreeScene& scene) {
  const auto corners = mesh_.corners(facet);
  const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
  const Vec3& n = mesh_.normals[facet];
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3 point = k == 3 ? middle : Vec3(0.5 * (middle + corners[k]));
    RTCRayHit ray = short_ray(facet, scene.placement().placed(point) - near * n, n);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.filter = skip_own_facet;
    rtcIntersect1(scene.scene(), &context, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;
    touched_[facet] = 1;
    touched_[ray.hit.primID] = 1;
  }
}

}  // namespace lrcs
