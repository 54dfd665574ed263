#include "lrcs/curved_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/edges.h"

namespace lrcs {
namespace {

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

CurvedSurface::Facet prepared(std::uint32_t facet, CurvedPatch patch, double square_metres) {
  CurvedSurface::Facet curved{facet, {}, Vec3::Zero(), 0.0, false, true, 0.0, patch};
  curved.adjacent.fill(CurvedSurface::none);
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < PatchRule::size; ++k) {
    double& area = curved.patch.area[k];
    area *= square_metres;
    curved.area += patch_rule().weight[k] * area;
    curved.folded = curved.folded || area < 0.0;
    curved.planar = curved.planar && area == curved.patch.area[0] && patch.normal[k] == patch.normal[0];
    sum += patch.normal[k];
  }
  curved.axis = curved.planar ? patch.normal[0] : Vec3(sum.normalized());
  double turn = 0.0;
  if (!curved.planar)
    for (const Vec3& normal : patch.normal) turn = std::max(turn, angle_between(curved.axis, normal));
  curved.spread = std::sin(std::min(CurvedSurface::beyond_places * turn, std::numbers::pi / 2.0));
  return curved;
}

}  // namespace

CurvedSurface::CurvedSurface(const FacetMesh& mesh) {
  if (mesh.curved.of.empty()) return;
  const double square_metres = mesh.metres_per_unit * mesh.metres_per_unit;
  places_.assign(mesh.size(), none);
  for (std::uint32_t k = 0; k < mesh.size(); ++k) {
    const std::uint32_t patch = mesh.curved.of[k];
    if (patch == CurvedFacets::flat) continue;
    places_[k] = static_cast<std::uint32_t>(facets_.size());
    facets_.push_back(prepared(k, mesh.curved.patches[patch], square_metres));
  }
  find_adjacent(mesh);
}

void CurvedSurface::find_adjacent(const FacetMesh& mesh) {
  std::vector<std::uint32_t> curved;
  curved.reserve(facets_.size());
  for (const Facet& f : facets_) {
    const auto& [a, b, c] = mesh.facets[f.facet];
    if (a != b && b != c && c != a) curved.push_back(f.facet);
  }
  const Edges edges(mesh, curved);
  const auto add = [&](std::uint32_t to, std::uint32_t other) {
    auto& adjacent = facets_[places_[to]].adjacent;
    *std::find(adjacent.begin(), adjacent.end() - 1, none) = other;
  };
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto uses = edges.uses(e);
    if (uses.size() != 2 || uses[0].rising == uses[1].rising) continue;
    const Facet &a = facets_[places_[uses[0].facet]], &b = facets_[places_[uses[1].facet]];
    // Beyond a crease the surface is another.
    if (angle_between(a.axis, b.axis) > std::asin(a.spread) + std::asin(b.spread)) continue;
    add(a.facet, b.facet);
    add(b.facet, a.facet);
  }
}

}  // namespace lrcs
