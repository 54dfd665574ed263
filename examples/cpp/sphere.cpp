// The library from C++: monostatic LRCS of a faceted sphere beside its closed form, at finer and finer facets.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numbers>

#include "brdf/library.h"
#include "lrcs/cross_section.h"
#include "lrcs/visibility.h"
#include "mesh/facet_mesh.h"

namespace {

constexpr double pi = std::numbers::pi;

lrcs::FacetMesh unit_sphere(std::uint32_t rings) {
  const std::uint32_t sectors = 2 * rings;
  lrcs::FacetMesh mesh;
  for (std::uint32_t i = 0; i <= rings; ++i)
    for (std::uint32_t k = 0; k < sectors; ++k) {
      const double t = pi * i / rings, phi = 2.0 * pi * k / sectors;
      const double radius = i == 0 || i == rings ? 0.0 : std::sin(t);
      mesh.positions.emplace_back(radius * std::cos(phi), radius * std::sin(phi), std::cos(t));
    }
  for (std::uint32_t i = 0; i < rings; ++i)
    for (std::uint32_t k = 0; k < sectors; ++k) {
      const std::uint32_t a = i * sectors + k, b = i * sectors + (k + 1) % sectors;
      if (i + 1 < rings) mesh.facets.push_back({a, a + sectors, b + sectors});
      if (i > 0) mesh.facets.push_back({a, b + sectors, b});
    }
  lrcs::measure_facets(mesh);
  return mesh;
}

}  // namespace

int main() {
  const double truth = 3.509758352;  // m^2: unit sphere of metal-skin-5p, 10 digits
  std::printf("facets   sigma [m^2]   error\n");
  double last_error = 0.0;
  for (const std::uint32_t rings : {20U, 40U, 80U}) {
    lrcs::Target target;
    target.mesh = unit_sphere(rings);
    target.materials = {*lrcs::find_in_library("metal-skin-5p")};
    target.material.assign(target.mesh.size(), 0);
    const lrcs::Visibility visibility(target.mesh);
    const lrcs::Vec3 nose_on(1, 0, 0);
    const lrcs::Estimate sigma = lrcs::cross_section(target, visibility, nose_on, nose_on).sigma;
    last_error = std::abs(sigma.value / truth - 1.0);
    std::printf("%6zu   %.9f   %.1e\n", target.mesh.size(), sigma.value, last_error);
  }
  return last_error < 1e-3 ? 0 : 1;
}
