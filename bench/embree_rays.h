#pragma once
#include <embree3/rtcore.h>

#include <vector>

#include "base/vec3.h"
#include "mesh/facet_mesh.h"

namespace lrcs::bench {

// What others do: ask a ray tracer which places of a target are seen. One thread; Embree's own advice is followed (one
// tree of high quality, packets of 16, denormals off), with the robust flag, for grazing rays slip through edges
// without.
class EmbreeRays {
 public:
  explicit EmbreeRays(const FacetMesh& mesh);
  ~EmbreeRays();
  EmbreeRays(const EmbreeRays&) = delete;
  EmbreeRays& operator=(const EmbreeRays&) = delete;

  // The seen fraction of every front facet, by side^2 stratified rays from it toward the viewer (1: from its middle).
  // shape: one a facet; 0 for those whose back is seen.
  [[nodiscard]] std::vector<double> from_facets(const Vec3& toward, unsigned side) const;

  // The seen fraction of every facet, by parallel rays through the middles of side^2 pixels of the target's picture.
  [[nodiscard]] std::vector<double> from_pixels(const Vec3& toward, unsigned side) const;

 private:
  const FacetMesh& mesh_;
  Vec3 centre_ = Vec3::Zero();
  double scale_ = 1.0;  // brings the target's size to 1: Embree's numbers are floats
  RTCDevice device_;
  RTCScene scene_;
};

}  // namespace lrcs::bench
