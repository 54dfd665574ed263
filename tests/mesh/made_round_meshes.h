#pragma once
#include <random>

#include "made_meshes.h"

namespace lrcs {

// An icosahedron, its facets in quarters so many times, on the unit sphere, outward; each vertex moved by up to
// `jitter` of an edge along the sphere.
inline FacetMesh jittered_ball(int levels, double jitter, unsigned seed) {
  const double t = std::numbers::phi;
  std::vector<Vec3> positions{{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                              {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
  Triangles facets{{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                   {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                   {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    Triangles quarters;
    std::vector<std::pair<std::array<std::uint32_t, 2>, std::uint32_t>> known;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const std::array<std::uint32_t, 2> edge{std::min(a, b), std::max(a, b)};
      for (const auto& [other, place] : known)
        if (other == edge) return place;
      positions.push_back(0.5 * (positions[a] + positions[b]));
      known.emplace_back(edge, static_cast<std::uint32_t>(positions.size() - 1));
      return known.back().second;
    };
    for (const auto& [a, b, c] : facets) {
      const std::uint32_t x = middle(a, b), y = middle(b, c), z = middle(c, a);
      quarters.insert(quarters.end(), {{a, x, z}, {b, y, x}, {c, z, y}, {x, y, z}});
    }
    facets = quarters;
  }
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> moved(-1.0, 1.0);
  const double edge = 1.1 / static_cast<double>(1 << levels);
  for (Vec3& p : positions) {
    p.normalize();
    p += jitter * edge * Vec3(moved(random), moved(random), moved(random));
    p.normalize();
  }
  return mesh_of(positions, facets);
}

// A cylinder of radius 1 and height `height` along z, of rectangles cut by one diagonal, with caps: outward.
inline FacetMesh cylinder(std::uint32_t sides, double height) {
  std::vector<Vec3> positions;
  Triangles facets;
  for (std::uint32_t k = 0; k < sides; ++k) {
    const double turn = 2.0 * std::numbers::pi * k / sides;
    for (const double z : {0.0, height}) positions.emplace_back(std::cos(turn), std::sin(turn), z);
  }
  for (std::uint32_t k = 0; k < sides; ++k) {
    const std::uint32_t a = 2 * k, b = 2 * ((k + 1) % sides);
    facets.push_back({a, b, b + 1});
    facets.push_back({a, b + 1, a + 1});
    if (k >= 1 && k + 1 < sides) {
      facets.push_back({0, b, a});
      facets.push_back({1, a + 1, b + 1});
    }
  }
  return mesh_of(positions, facets);
}

}  // namespace lrcs
