#include "lrcs/occluders.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "base/large_pages.h"
#include "lrcs/space_order.h"
#include "mesh/facet_crosses.h"
#include "mesh/weld.h"

namespace lrcs {
namespace {

// Calls work(first, last) for ranges that make up 0..count, several at a time.
template <class Work>
void for_ranges(std::size_t count, const Work& work) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 4096),
                    [&](const auto& range) { work(range.begin(), range.end()); });
}

// A power of two, exactly; in two steps, of which each is a double whatever the size.
struct Scale {
  double half = 1.0, rest = 1.0;

  [[nodiscard]] Vec3 of(const Vec3& length) const { return (length * half) * rest; }
};

// To unit size. What no facet uses says nothing of the size.
Scale scale_of(const FacetMesh& mesh) {
  double size = 0.0;
  for (const auto& facet : mesh.facets)
    for (const std::uint32_t v : facet) size = std::max(size, mesh.positions[v].cwiseAbs().maxCoeff());
  if (size == 0.0) return {};
  const int exponent = std::ilogb(size);
  return {std::ldexp(1.0, -exponent / 2), std::ldexp(1.0, -exponent - (-exponent / 2))};
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
  std::vector<T> permuted = large_vector<T>(values.size());
  for_ranges(order.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) permuted[k] = values[order[k]];
  });
  values = std::move(permuted);
}

// Turns the corners so that the first one is opposite to the longest side; value: which one it was.
std::uint8_t turn_to_longest_side(const std::vector<Vec3>& positions, std::array<std::uint32_t, 3>& corners) {
  const Vec3 &a = positions[corners[0]], &b = positions[corners[1]], &c = positions[corners[2]];
  const std::array<double, 3> opposite{(c - b).squaredNorm(), (a - c).squaredNorm(), (b - a).squaredNorm()};
  const auto first = std::max_element(opposite.begin(), opposite.end()) - opposite.begin();
  std::rotate(corners.begin(), corners.begin() + first, corners.end());
  return static_cast<std::uint8_t>(first);
}

}  // namespace

Occluders::Occluders(const FacetMesh& mesh) {
  reserve_large(positions, mesh.positions.size());
  positions = mesh.positions;
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
    if (!all.sagittas.empty()) sagittas.push_back(all.sagittas[f]);
    if (!all.first_corner.empty()) first_corner.push_back(all.first_corner[f]);
    original.push_back(all.original[f]);
  }
  order_vertices();
}

void Occluders::take_facets(const FacetMesh& mesh) {
  for (Vec3& p : positions) p += Vec3::Zero();  // zero has one sign
  const auto vertex = keep_different(positions);
  const Scale scale = scale_of(mesh);
  for (Vec3& p : positions) p = scale.of(p);
  facets = large_vector<std::array<std::uint32_t, 3>>(mesh.size());
  cross = large_vector<Vec3>(mesh.size());
  const bool curved = !mesh.curved.of.empty();
  if (curved) first_corner.resize(mesh.size());
  for_ranges(mesh.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f) {
      const auto& c = mesh.facets[f];
      facets[f] = {vertex[c[0]], vertex[c[1]], vertex[c[2]]};
      const std::uint8_t turned = turn_to_longest_side(positions, facets[f]);
      if (curved) first_corner[f] = turned;
    }
    facet_crosses(positions, std::span(facets).subspan(first, last - first), std::span(cross).subspan(first));
  });
  keep_areas();
  if (!curved) return;
  for (std::size_t k = 0; k < size(); ++k) {
    auto& normals = corner_normals.emplace_back(normals_at_corners(mesh, original[k], cross[k]));
    std::rotate(normals.begin(), normals.begin() + first_corner[k], normals.end());
    auto& sides = sagittas.emplace_back();
    sides.fill(Vec3::Zero());
    const std::uint32_t patch = mesh.curved.of[original[k]];
    if (patch == CurvedFacets::flat) continue;
    for (std::size_t side = 0; side < 3; ++side)
      sides[side] = scale.of(mesh.curved.patches[patch].sagitta[(side + first_corner[k]) % 3]);
  }
}

void Occluders::keep_areas() {
  reserve_large(original, size());
  for (std::uint32_t f = 0; f < size(); ++f)
    if (!cross[f].isZero(0.0)) original.push_back(f);
  if (original.size() == size()) return;
  for (std::size_t k = 0; k < original.size(); ++k) {
    facets[k] = facets[original[k]];
    cross[k] = cross[original[k]];
    if (!first_corner.empty()) first_corner[k] = first_corner[original[k]];
  }
  facets.resize(original.size());
  cross.resize(original.size());
  if (!first_corner.empty()) first_corner.resize(original.size());
}

void Occluders::order_facets() {
  std::vector<Vec3> centres = large_vector<Vec3>(size());
  for_ranges(size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const auto& f = facets[k];
      centres[k] = positions[f[0]] / 3.0 + positions[f[1]] / 3.0 + positions[f[2]] / 3.0;
    }
  });
  const auto order = space_order(centres);
  permute(facets, order);
  permute(cross, order);
  permute(original, order);
  if (!corner_normals.empty()) permute(corner_normals, order);
  if (!sagittas.empty()) permute(sagittas, order);
  if (!first_corner.empty()) permute(first_corner, order);
}

void Occluders::order_vertices() {
  constexpr std::uint32_t unused = 0xffffffff;
  std::vector<std::uint32_t> place(positions.size(), unused);
  std::vector<Vec3> used;
  reserve_large(used, positions.size());
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
