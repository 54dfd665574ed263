#include "bench/bumpy_sphere.h"

#include <cmath>
#include <numbers>

namespace lrcs::bench {
namespace {

Vec3 place(double p, double t) {
  const double s = std::sin(t);
  const double wave =
      std::sin(7.0 * p) * s * s * std::cos(9.0 * t) + 0.5 * std::sin(23.0 * p + 1.0) * s * s * s * std::sin(31.0 * t);
  return (1.0 + 0.1 * wave) * Vec3(s * std::cos(p), s * std::sin(p), std::cos(t));
}

}  // namespace

FacetMesh bumpy_sphere(unsigned rings) {
  const unsigned sectors = 2 * rings;
  FacetMesh mesh;
  mesh.positions.push_back(Vec3::UnitZ());
  for (unsigned ring = 1; ring < rings; ++ring)
    for (unsigned k = 0; k < sectors; ++k)
      mesh.positions.push_back(place(2.0 * std::numbers::pi * k / sectors, std::numbers::pi * ring / rings));
  mesh.positions.emplace_back(-Vec3::UnitZ());
  const auto last = static_cast<std::uint32_t>(mesh.positions.size() - 1);
  const auto id = [&](unsigned ring, unsigned k) { return 1 + (ring - 1) * sectors + k % sectors; };
  for (unsigned k = 0; k < sectors; ++k) {
    mesh.facets.push_back({0, id(1, k), id(1, k + 1)});
    mesh.facets.push_back({last, id(rings - 1, k + 1), id(rings - 1, k)});
  }
  for (unsigned ring = 1; ring + 1 < rings; ++ring)
    for (unsigned k = 0; k < sectors; ++k) {
      mesh.facets.push_back({id(ring, k), id(ring + 1, k), id(ring + 1, k + 1)});
      mesh.facets.push_back({id(ring, k), id(ring + 1, k + 1), id(ring, k + 1)});
    }
  measure_facets(mesh);
  return mesh;
}

}  // namespace lrcs::bench
