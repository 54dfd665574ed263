#include "lrcs/touching_facets.h"

#include <array>

#include "lrcs/embree_scene.h"
#include "lrcs/placement.h"

namespace lrcs {
namespace {

RTCRayHit short_ray(std::uint32_t facet, const Vec3& from, const Vec3& along) {
  RTCRayHit ray{};
  ray.ray.org_x = static_cast<float>(from.x());
  ray.ray.org_y = static_cast<float>(from.y());
  ray.ray.org_z = static_cast<float>(from.z());
  ray.ray.dir_x = static_cast<float>(along.x());
  ray.ray.dir_y = static_cast<float>(along.y());
  ray.ray.dir_z = static_cast<float>(along.z());
  ray.ray.tfar = static_cast<float>(2.0 * float_error);
  ray.ray.mask = ~0U;
  ray.ray.id = facet;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  return ray;
}

}  // namespace

TouchingFacets::TouchingFacets(const Target& target, const EmbreeScene& scene) : mesh_(target.mesh), scene_(scene) {
  if (target.has_one_material() && target.sides == Sides::both) return;
  touched_.assign(mesh_.size(), 0);
  const FlushDenormals flush;
  for (std::uint32_t f = 0; f < mesh_.size(); ++f) probe(f);
}

void TouchingFacets::probe(std::uint32_t facet) {
  const auto corners = mesh_.corners(facet);
  const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3 point = k == 3 ? middle : Vec3(0.5 * (middle + corners[k]));
    const std::uint32_t other = facet_at(facet, scene_.placement().placed(point));
    if (other == nothing) continue;
    none_ = false;
    touched_[facet] = 1;
    touched_[other] = 1;
  }
}

std::uint32_t TouchingFacets::facet_at(std::uint32_t facet, const Vec3& place) const {
  const Vec3& n = mesh_.normals[facet];
  RTCRayHit ray = short_ray(facet, place - float_error * n, n);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.filter = skip_own_facet;
  rtcIntersect1(scene_.scene(), &context, &ray);
  return ray.hit.geomID == RTC_INVALID_GEOMETRY_ID ? nothing : ray.hit.primID;
}

}  // namespace lrcs
