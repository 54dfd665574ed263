#include "bench/bumpy_sphere.h"

#include <cassert>
#include <cmath>
#include <numbers>

#include "mesh/mesh_builder.h"

namespace lrcs {
namespace {

constexpr double pi = std::numbers::pi;

Vec3 on_bumpy_sphere(double p, double t) {
  constexpr double h = 0.1;
  const double s = std::sin(t);
  const double bumps =
      std::sin(7.0 * p) * s * s * std::cos(9.0 * t) + 0.5 * std::sin(23.0 * p + 1.0) * s * s * s * std::sin(31.0 * t);
  const double r = 1.0 + h * bumps;
  return {r * s * std::cos(p), r * s * std::sin(p), r * std::cos(t)};
}

}  // namespace

FacetMesh bumpy_sphere(std::uint32_t rings) {
  assert(rings >= 2);
  const std::uint32_t sectors = 2 * rings;
  MeshBuilder mesh;
  const std::uint32_t top = mesh.add_position(on_bumpy_sphere(0.0, 0.0));
  for (std::uint32_t i = 1; i < rings; ++i)
    for (std::uint32_t j = 0; j < sectors; ++j)
      mesh.add_position(on_bumpy_sphere(2.0 * pi * j / sectors, pi * i / rings));
  const std::uint32_t bottom = mesh.add_position(on_bumpy_sphere(0.0, pi));

  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) { mesh.add_polygon(std::array{a, b, c}); };
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return 1 + (i - 1) * sectors + j % sectors; };
  for (std::uint32_t j = 0; j < sectors; ++j) add(top, at(1, j), at(1, j + 1));
  for (std::uint32_t i = 1; i + 1 < rings; ++i)
    for (std::uint32_t j = 0; j < sectors; ++j) {
      add(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      add(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  for (std::uint32_t j = 0; j < sectors; ++j) add(bottom, at(rings - 1, j + 1), at(rings - 1, j));
  return mesh.finish();
}

}  // namespace lrcs
