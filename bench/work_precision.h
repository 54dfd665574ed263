#pragma once
#include <string>
#include <vector>

#include "mesh/facet_mesh.h"

namespace lrcs::bench {

// One method on one target from one direction.
struct Measurement {
  std::string target;
  std::size_t facets = 0;
  double azimuth_deg = 0.0, elevation_deg = 0.0;
  std::string method;
  double seconds = 0.0;           // median of the repetitions
  double error_seen_area = 0.0;   // relative to exact
  double error_lambert = 0.0;     // of sigma
  double error_metal_skin = 0.0;  // of sigma, metal-skin-5p
};

// The method that others are compared with: what private scripts do.
inline constexpr const char* one_ray_a_facet = "1 Embree ray a facet";

// Error and time of every method, monostatic, one thread, what is built once per target left out. The methods take
// turns, so that whatever else the machine does slows all alike. Directions are seeded.
// Errors of rays from facets are those of the front facets alone, of which they know.
[[nodiscard]] std::vector<Measurement> measure(const std::string& name, const FacetMesh& mesh, unsigned directions,
                                               bool short_run);

}  // namespace lrcs::bench
