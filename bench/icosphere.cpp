#include "bench/icosphere.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace lrcs {
namespace {

FacetMesh icosahedron() {
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  FacetMesh mesh;
  mesh.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                    {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (Vec3& p : mesh.positions) p.normalize();
  mesh.facets = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                 {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                 {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  return mesh;
}

void subdivide(FacetMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), mesh.positions.size());
    if (is_new) mesh.positions.push_back((mesh.positions[a] + mesh.positions[b]).normalized());
    return found->second;
  };
  std::vector<std::array<std::uint32_t, 3>> finer;
  finer.reserve(4 * mesh.facets.size());
  for (const auto& [a, b, c] : mesh.facets) {
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const auto& facet : {std::array{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}}) finer.push_back(facet);
  }
  mesh.facets = std::move(finer);
}

}  // namespace

FacetMesh icosphere(std::uint32_t subdivisions) {
  FacetMesh mesh = icosahedron();
  for (std::uint32_t k = 0; k < subdivisions; ++k) subdivide(mesh);
  measure_facets(mesh);
  return mesh;
}

}  // namespace lrcs
