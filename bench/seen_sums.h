#pragma once
#include <vector>

#include "base/vec3.h"
#include "mesh/facet_mesh.h"

namespace lrcs {

// What a method is judged by: monostatic sums over the facets' front sides.
struct SeenSums {
  double sigma_lambert = 0.0;  // [m^2], reflectance 0.5
  double sigma_wu = 0.0;       // [m^2], metal-skin-5p
  double seen_area = 0.0;      // [m^2], projected
};

// From the seen fraction of every facet; facets that turn their back to the viewer count nothing.
// Fronts only, because engineers cast rays from front facets only: what shows its back on an open target would count
// as their error, and is another question.
[[nodiscard]] SeenSums seen_sums(const FacetMesh& mesh, const std::vector<double>& seen_fraction,
                                 const Vec3& to_viewer);

// The standard deviation of the same sums where each facet is judged by one ray from a random point of it.
[[nodiscard]] SeenSums one_ray_deviation(const FacetMesh& mesh, const std::vector<double>& seen_fraction,
                                         const Vec3& to_viewer);

// |found - truth| / truth, and part / whole, one by one.
[[nodiscard]] SeenSums relative_errors(const SeenSums& found, const SeenSums& truth);
[[nodiscard]] SeenSums quotient(const SeenSums& part, const SeenSums& whole);

}  // namespace lrcs
