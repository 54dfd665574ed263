#include "lrcs/occluders.h"

#include <algorithm>
#include <cmath>

#include "lrcs/space_order.h"
#include "mesh/weld.h"

namespace lrcs {
namespace {

// Powers of two are exact. What no facet uses says nothing of the size.
void scale_to_unit_size(std::vector<Vec3>& positions, const FacetMesh& mesh) {
  double size = 0.0;
  for (const auto& facet : mesh.facets)
    for (const std::uint32_t v : facet) size = std::max(size, mesh.positions[v].cwiseAbs().maxCoeff());
  if (size == 0.0) return;
  const int exponent = std::ilogb(size);
  // In two steps, of which each is a double whatever the size.
  const double half = std::ldexp(1.0, -exponent / 2), rest = std::ldexp(1.0, -exponent - (-exponent / 2));
  for (Vec3& p : positions) p = (p * half) * rest;
}

std::array<Vec3, 3> normals_at_corners(const FacetMesh& mesh, std::uint32_t facet, const Vec3& cross) {
  const std::uint32_t patch = mesh.curved.of[facet];
  std::array<Vec3, 3> normals;
  normals.fill(cross);
  if (patch != CurvedFacets::flat) {
    const PatchPolynomial surface(mesh.curved.patches[patch]);
    normals = {surface.at({1.0, 0.0, 0.0}), surface.at({0.0, 1.0, 0.0}), surface.at({0.0, 0.0, 1.0})};
  }
  for (Vec3& normal : normals) normal.stableNormalize();
  return normals;
}

template <class T>
void permute(std::vector<T>& values, const std::vector<std::uint32_t>& order) {
  std::vector<T> permuted;
  permuted.reserve(values.size());
  for (const std::uint32_t k : order) permuted.push_back(values[k]);
  values = std::move(permuted);
}

}  // namespace

Occluders::Occluders(const FacetMesh& mesh) : positions(mesh.positions) {
  take_facets(mesh);
  order_facets();
  order_vertices();
}

Occluders::Occluders(const Occluders& all, const std::vector<std::uint8_t>& kept) : positions(all.positions) {
  for (std::size_t f = 0; f < all.size(); ++f) {
    if (kept[f] == 0) continue;
    facets.push_back(all.facets[f]);
    cross.push_back(all.cross[f]);
    if (!all.corner_normals.empty()) corner_normals.push_back(all.corner_normals[f]);
    if (!all.first_corner.empty()) first_corner.push_back(all.first_corner[f]);
    original.push_back(all.original[f]);
  }
  order_vertices();
}

void Occluders::take_facets(const FacetMesh& mesh) {
  for (Vec3& p : positions) p += Vec3::Zero();  // zero has one sign
  const auto vertex = keep_different(positions);
  scale_to_unit_size(positions, mesh);
  for (std::uint32_t f = 0; f < mesh.size(); ++f) {
    const auto& c = mesh.facets[f];
    std::array<std::uint32_t, 3> ids{vertex[c[0]], vertex[c[1]], vertex[c[2]]};
    const Vec3 &a = positions[ids[0]], &b = positions[ids[1]], &d = positions[ids[2]];
    const std::array<double, 3> opposite{(d - b).squaredNorm(), (a - d).squaredNorm(), (b - a).squaredNorm()};
    const auto first = std::max_element(opposite.begin(), opposite.end()) - opposite.begin();
    std::rotate(ids.begin(), ids.begin() + first, ids.end());
    const Vec3 normal = facet_cross(positions[ids[0]], positions[ids[1]], positions[ids[2]]);
    if (normal.isZero(0.0)) continue;
    facets.push_back(ids);
    cross.push_back(normal);
    original.push_back(f);
    if (mesh.curved.of.empty()) continue;
    auto& normals = corner_normals.emplace_back(normals_at_corners(mesh, f, normal));
    first_corner.push_back(static_cast<std::uint8_t>(first));
    std::rotate(normals.begin(), normals.begin() + first, normals.end());
  }
}

void Occluders::order_facets() {
  std::vector<Vec3> centres;
  centres.reserve(size());
  for (const auto& f : facets)
    centres.emplace_back(positions[f[0]] / 3.0 + positions[f[1]] / 3.0 + positions[f[2]] / 3.0);
  const auto order = space_order(centres);
  permute(facets, order);
  permute(cross, order);
  permute(original, order);
  if (!corner_normals.empty()) permute(corner_normals, order);
  if (!first_corner.empty()) permute(first_corner, order);
}

void Occluders::order_vertices() {
  constexpr std::uint32_t unused = 0xffffffff;
  std::vector<std::uint32_t> place(positions.size(), unused);
  std::vector<Vec3> used;
  for (auto& f : facets)
    for (auto& v : f) {
      if (place[v] == unused) {
        place[v] = static_cast<std::uint32_t>(used.size());
        used.push_back(positions[v]);
      }
      v = place[v];
    }
  positions = std::move(used);
  if (positions.empty()) return;
  Vec3 low = positions.front(), high = low;
  for (const Vec3& p : positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  centre = 0.5 * low + 0.5 * high;
}

}  // namespace lrcs
