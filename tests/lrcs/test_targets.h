#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "base/vec3.h"
#include "brdf/library.h"
#include "lrcs/cross_section.h"
#include "mesh/facet_mesh.h"

namespace lrcs {

inline std::uint32_t add_vertex(FacetMesh& mesh, const Vec3& p) {
  mesh.positions.push_back(p);
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

inline void add_facet(FacetMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  mesh.facets.push_back({a, b, c});
  mesh.part.of.push_back(0);
  mesh.file_material.of.push_back(0);
  mesh.source_facet.push_back(static_cast<std::uint32_t>(mesh.facets.size() - 1));
  mesh.part.names = {""};
  mesh.file_material.names = {""};
}

inline void add_triangle(FacetMesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto first = add_vertex(mesh, a);
  add_facet(mesh, first, add_vertex(mesh, b), add_vertex(mesh, c));
}

// A parallelogram p, p + u, p + u + v, p + v as two facets; the front is along u x v.
inline void add_plate(FacetMesh& mesh, const Vec3& p, const Vec3& u, const Vec3& v) {
  const auto a = add_vertex(mesh, p), b = add_vertex(mesh, p + u), c = add_vertex(mesh, p + u + v),
             d = add_vertex(mesh, p + v);
  add_facet(mesh, a, b, c);
  add_facet(mesh, a, c, d);
}

// The same cut into count x count plates that share their vertices.
inline void add_tiled_plate(FacetMesh& mesh, const Vec3& p, const Vec3& u, const Vec3& v, std::uint32_t count) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::uint32_t k = 0; k <= count; ++k)
    for (std::uint32_t i = 0; i <= count; ++i) add_vertex(mesh, p + i * u / count + k * v / count);
  for (std::uint32_t k = 0; k < count; ++k)
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t a = first + k * (count + 1) + i;
      add_facet(mesh, a, a + 1, a + count + 2);
      add_facet(mesh, a, a + count + 2, a + count + 1);
    }
}

inline void add_box(FacetMesh& mesh, const Vec3& low, const Vec3& high) {
  const Vec3 s = high - low;
  const Vec3 x(s.x(), 0, 0), y(0, s.y(), 0), z(0, 0, s.z());
  add_plate(mesh, low, y, x);
  add_plate(mesh, low + z, x, y);
  add_plate(mesh, low, x, z);
  add_plate(mesh, low + y, z, x);
  add_plate(mesh, low, z, y);
  add_plate(mesh, low + x, y, z);
}

inline FacetMesh box(const Vec3& low, const Vec3& high) {
  FacetMesh mesh;
  add_box(mesh, low, high);
  return mesh;
}

// With every facet's front and back exchanged.
inline FacetMesh reversed(FacetMesh mesh) {
  for (auto& f : mesh.facets) std::swap(f[1], f[2]);
  return mesh;
}

inline void append(FacetMesh& mesh, const FacetMesh& other, const Vec3& shift = Vec3::Zero()) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const Vec3& p : other.positions) mesh.positions.push_back(p + shift);
  for (const auto& f : other.facets) add_facet(mesh, first + f[0], first + f[1], first + f[2]);
}

// A surface of revolution about z: radius and height along the profile, from the bottom up; the front is outward.
// Points on the axis make fans.
inline FacetMesh revolved(const std::vector<std::pair<double, double>>& profile, std::uint32_t sectors) {
  FacetMesh mesh;
  for (const auto& [r, z] : profile)
    for (std::uint32_t k = 0; k < sectors; ++k) {
      const double phi = 2.0 * std::numbers::pi * k / sectors;
      add_vertex(mesh, {r * std::cos(phi), r * std::sin(phi), z});
    }
  for (std::uint32_t ring = 0; ring + 1 < profile.size(); ++ring)
    for (std::uint32_t k = 0; k < sectors; ++k) {
      const std::uint32_t a = ring * sectors + k, b = ring * sectors + (k + 1) % sectors;
      if (profile[ring].first > 0.0) add_facet(mesh, a, b, profile[ring + 1].first > 0.0 ? b + sectors : a + sectors);
      if (profile[ring + 1].first > 0.0) add_facet(mesh, a, b + sectors, a + sectors);
    }
  return mesh;
}

inline FacetMesh sphere(double radius, std::uint32_t rings) {
  std::vector<std::pair<double, double>> profile;
  for (std::uint32_t k = 0; k <= rings; ++k) {
    const double t = std::numbers::pi * k / rings;
    const bool pole = k == 0 || k == rings;
    profile.emplace_back(pole ? 0.0 : radius * std::sin(t), -radius * std::cos(t));
  }
  return revolved(profile, 2 * rings);
}

// An icosahedron in the unit sphere, each facet divided into four, `levels` times over: convex, every facet for itself.
inline FacetMesh icosphere(int levels) {
  const double g = 0.5 + 0.5 * std::sqrt(5.0);
  std::vector<Vec3> at{{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                       {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  std::vector<std::array<std::uint32_t, 3>> facets{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                                   {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                                   {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                                   {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  FacetMesh mesh;
  for (const Vec3& p : at) add_vertex(mesh, p.normalized());
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), mesh.positions.size());
      if (is_new) add_vertex(mesh, (mesh.positions[a] + mesh.positions[b]).normalized());
      return found->second;
    };
    std::vector<std::array<std::uint32_t, 3>> finer;
    for (const auto& [a, b, c] : facets) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const auto& f : {std::array{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}}) finer.push_back(f);
    }
    facets = std::move(finer);
  }
  for (const auto& [a, b, c] : facets) add_facet(mesh, a, b, c);
  return mesh;
}

// Facets anywhere: open, interpenetrating, some sharing vertices.
inline FacetMesh random_soup(std::mt19937_64& random, int facets) {
  std::uniform_real_distribution<double> at(-1.0, 1.0), size(-0.5, 0.5);
  FacetMesh mesh;
  const auto vec = [&](auto& from) { return Vec3(from(random), from(random), from(random)); };
  for (int k = 0; k < facets; ++k) {
    const Vec3 p = vec(at);
    if (k % 3 == 0 || mesh.positions.empty()) {
      add_triangle(mesh, p, p + vec(size), p + vec(size));
    } else {
      std::uniform_int_distribution<std::size_t> any(0, mesh.positions.size() - 1);
      const Vec3 q = mesh.positions[any(random)];
      add_triangle(mesh, q, q + vec(size), q + vec(size));
    }
  }
  return mesh;
}

inline Vec3 random_direction(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return Vec3(normal(random), normal(random), normal(random)).normalized();
}

inline Target target_of(FacetMesh mesh, const Brdf& brdf) {
  Target target;
  target.mesh = std::move(mesh);
  measure_facets(target.mesh);
  target.materials = {{"m", brdf, 0.0, ""}};
  target.material.assign(target.mesh.size(), 0);
  return target;
}

inline Brdf lambert(double reflectance) {
  return Lambert(reflectance);
}
inline Brdf library(const char* name) {
  return find_in_library(name)->brdf;
}

inline CrossSection section_of(const Target& target, const Vec3& di, const Vec3& dr) {
  return cross_section(target, Visibility(target.mesh), di, dr);
}

}  // namespace lrcs
