#pragma once
#include <embree3/rtcore.h>

#include <span>

#include "lrcs/placement.h"
#include "mesh/facet_mesh.h"

namespace lrcs {

// A target in Embree: one BVH of high build quality, robust traversal, one thread.
// frame: that of Placement: Embree knows floats only, and its offsets are absolute.
class EmbreeScene {
 public:
  // error: std::runtime_error with Embree's code where it fails.
  explicit EmbreeScene(const FacetMesh& mesh);
  ~EmbreeScene();
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  [[nodiscard]] RTCScene scene() const { return scene_; }
  [[nodiscard]] const Placement& placement() const { return placement_; }
  // A facet's corner in Embree's frame, as Embree has it.
  [[nodiscard]] std::span<const float, 3> corner(std::size_t facet, std::size_t k) const {
    return std::span<const float, 3>(vertices_ + 3 * std::size_t{facets_[3 * facet + k]}, 3);
  }

 private:
  void attach(const FacetMesh& mesh);
  void check() const;

  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
  const float* vertices_ = nullptr;  // Embree's buffers
  const unsigned* facets_ = nullptr;
  Placement placement_;
};

// The width of Embree's widest packets.
inline constexpr std::size_t packet_width = 16;

// Sets all of a packet's rays but where they start, how far they reach and whose they are.
void aim(RTCRay16& rays, const Vec3& along);

// A filter for rays whose id is the facet that they start from: they do not meet that one.
void skip_own_facet(const RTCFilterFunctionNArguments* hits);

// While one lives, this thread's denormal numbers are zero, as Embree advises: it would slow down on them.
class FlushDenormals {
 public:
  FlushDenormals();
  ~FlushDenormals();
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  unsigned before_;
};

}  // namespace lrcs
