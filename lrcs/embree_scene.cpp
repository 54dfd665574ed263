#include "lrcs/embree_scene.h"

#include <fmt/format.h>
#include <pmmintrin.h>
#include <xmmintrin.h>

#include <algorithm>
#include <stdexcept>

namespace lrcs {

EmbreeScene::EmbreeScene(const FacetMesh& mesh) : device_(rtcNewDevice("threads=1,set_affinity=0")), placement_(mesh) {
  if (device_ == nullptr) throw std::runtime_error("Embree: no device");
  scene_ = rtcNewScene(device_);
  rtcSetSceneFlags(scene_, static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
  rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
  attach(mesh);
  const FlushDenormals flush;
  rtcCommitScene(scene_);
  check();
}

EmbreeScene::~EmbreeScene() {
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

void EmbreeScene::attach(const FacetMesh& mesh) {
  RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                             3 * sizeof(float), mesh.positions.size()));
  auto* corner = static_cast<unsigned*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), mesh.size()));
  check();
  vertices_ = vertex;
  facets_ = corner;
  for (const Vec3& p : mesh.positions) {
    const Vec3 q = placement_.placed(p);
    for (int axis = 0; axis < 3; ++axis) *vertex++ = static_cast<float>(q[axis]);
  }
  for (const auto& facet : mesh.facets)
    for (const std::uint32_t k : facet) *corner++ = k;
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_, geometry);
  rtcReleaseGeometry(geometry);
}

void EmbreeScene::check() const {
  const RTCError error = rtcGetDeviceError(device_);
  if (error != RTC_ERROR_NONE) throw std::runtime_error(fmt::format("Embree: error {}", static_cast<int>(error)));
}

void aim(RTCRay16& rays, const Vec3& along) {
  std::fill_n(rays.dir_x, packet_width, static_cast<float>(along.x()));
  std::fill_n(rays.dir_y, packet_width, static_cast<float>(along.y()));
  std::fill_n(rays.dir_z, packet_width, static_cast<float>(along.z()));
  std::fill_n(rays.tnear, packet_width, 0.0F);
  std::fill_n(rays.mask, packet_width, ~0U);
  std::fill_n(rays.flags, packet_width, 0U);
  std::fill_n(rays.time, packet_width, 0.0F);
}

void skip_own_facet(const RTCFilterFunctionNArguments* hits) {
  for (unsigned k = 0; k < hits->N; ++k)
    if (hits->valid[k] == -1 && RTCHitN_primID(hits->hit, hits->N, k) == RTCRayN_id(hits->ray, hits->N, k))
      hits->valid[k] = 0;
}

FlushDenormals::FlushDenormals() : before_(_mm_getcsr()) {
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
  _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
}

FlushDenormals::~FlushDenormals() {
  _mm_setcsr(before_);
}

}  // namespace lrcs
