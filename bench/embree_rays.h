#pragma once
#include <cstdint>
#include <vector>

#include "lrcs/embree_scene.h"

namespace lrcs {

// What most LRCS programs do: rays from points of every front facet toward the viewer; seen are those that nothing
// stops. Occlusion rays in packets of 16, in the facets' order; hits of the ray's own facet are skipped.
// The points: the centroid; or strata^2 of them, one at random in each of as many congruent triangles. Own numbers
// are drawn for every facet, the same for every call.
class EmbreeRays {
 public:
  // Keeps references.
  EmbreeRays(const FacetMesh& mesh, const EmbreeScene& scene);

  // Casts strata^2 rays a front facet. domain: strata in 1..255.
  void cast(const Vec3& to_viewer, std::uint32_t strata);

  // Of the last cast. shape: one a facet; 0 for those that turn their back.
  [[nodiscard]] std::vector<double> seen_fraction() const;

 private:
  struct Packet;
  void cast_from_centroids(const Vec3& to_viewer);
  void cast_from_strata(const Vec3& to_viewer, std::uint32_t strata);

  const FacetMesh& mesh_;
  const EmbreeScene& scene_;
  std::vector<float> centroids_;      // three a facet, in Embree's frame
  std::vector<std::uint16_t> clear_;  // rays that nothing stopped, of each facet
  std::uint32_t rays_a_facet_ = 1;
};

}  // namespace lrcs
