#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "bench/seen_sums.h"
#include "mesh/facet_mesh.h"
#include "view/private_display.h"

namespace lrcs {

// One way to find what is seen of a target.
struct Method {
  std::string family;                                    // a curve of the diagram
  std::string name;                                      // within all of them
  std::string mark;                                      // beside its point of the curve
  double effort = 1.0;                                   // within the family: time grows in proportion
  std::function<void(const Vec3& to_viewer)> look;       // what is timed
  std::function<SeenSums(const Vec3& to_viewer)> found;  // of the last look; not timed
  // The relative error that only a fault explains, in this method or in the exact one; `deviation`: the relative
  // standard deviation of one ray from a random point of every facet.
  std::function<double(double deviation)> allowed;
  // What the method itself says of the last look: a bound of its relative error of sigma (metal-skin-5p). Empty: none.
  std::function<double()> bound = nullptr;
};

// What was built once for a target, and what it took.
struct Building {
  std::string what;
  double seconds = 0.0;
  double bytes = 0.0;  // growth of the process at its peak, the first look included; NaN where unknown
};

struct Methods {
  std::vector<Method> all;  // the first is the exact one, whose sums are the truth
  std::vector<Building> built;
  std::function<SeenSums(const Vec3& to_viewer)> deviation;  // see Method::allowed; after the exact look
};

// The exact seen fractions; and the exact method up to a cross section with its bound.
inline constexpr const char* exact_family = "exact";
inline constexpr const char* exact_to_sigma_family = "exact to sigma";
inline constexpr const char* relative_family = "relative accuracy";
inline constexpr const char* one_ray = "Embree, 1 ray a facet";  // what all others are compared with

// What others use.
inline constexpr const char* facet_rays_family = "Embree rays from facets";
inline constexpr const char* ray_grid_family = "Embree ray grid";
inline constexpr const char* z_buffer_family = "OpenGL z-buffer";
[[nodiscard]] inline bool is_baseline(const std::string& family) {
  return family == facet_rays_family || family == ray_grid_family || family == z_buffer_family;
}

// How fine the sampling methods go.
struct Fineness {
  std::vector<std::uint32_t> strata{1, 2, 4, 8, 16};  // squared: rays a facet
  std::vector<std::uint32_t> grid_sizes{32, 64, 128, 256, 512, 1024, 2048, 4096};
};

// All methods, ready for a target, which must outlive them. A new method has its place in methods.cpp.
// display: for the z-buffer; null: without it.
[[nodiscard]] Methods methods_for(const FacetMesh& mesh, const Fineness& fineness, const PrivateDisplay* display);

}  // namespace lrcs
