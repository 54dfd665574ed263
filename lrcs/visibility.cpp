#include "lrcs/visibility.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lrcs/facet_view.h"

namespace lrcs {
namespace {

// One vertex for every position. Zero has one sign.
void merge_equal_positions(FacetMesh& mesh) {
  for (Vec3& p : mesh.positions) p += Vec3::Zero();
  std::vector<std::uint32_t> order(mesh.positions.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto less = [&](std::uint32_t a, std::uint32_t b) {
    const Vec3 &p = mesh.positions[a], &q = mesh.positions[b];
    return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
  };
  std::sort(order.begin(), order.end(), less);
  std::vector<Vec3> kept;
  std::vector<std::uint32_t> kept_of(mesh.positions.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k == 0 || less(order[k - 1], order[k])) kept.push_back(mesh.positions[order[k]]);
    kept_of[order[k]] = static_cast<std::uint32_t>(kept.size() - 1);
  }
  for (auto& facet : mesh.facets)
    for (auto& v : facet) v = kept_of[v];
  mesh.positions = std::move(kept);
}

// Powers of two: exact, and products of three lengths can neither overflow nor vanish.
void scale_to_unit_size(FacetMesh& mesh) {
  double size = 0.0;
  for (const Vec3& p : mesh.positions) size = std::max(size, p.cwiseAbs().maxCoeff());
  if (size == 0.0) return;
  const int exponent = std::ilogb(size);
  for (Vec3& p : mesh.positions)
    for (double& x : p) x = std::ldexp(x, -exponent);
}

}  // namespace

Visibility::Visibility(const FacetMesh& mesh) {
  mesh_.positions = mesh.positions;
  mesh_.facets = mesh.facets;
  merge_equal_positions(mesh_);
  scale_to_unit_size(mesh_);
  measure_facets(mesh_);
  std::vector<std::uint32_t> facets;
  for (std::uint32_t f = 0; f < mesh_.size(); ++f)
    if (mesh_.areas[f] > 0.0) facets.push_back(f);
  tree_ = std::make_unique<FacetTree>(mesh_, std::move(facets));
}

std::vector<Estimate> Visibility::seen_fraction(const Vec3& to_transmitter, const Vec3& to_receiver) const {
  FacetView view(mesh_, *tree_);
  if (to_transmitter == to_receiver)
    view.look_along({to_receiver});
  else
    view.look_along({to_transmitter, to_receiver});
  std::vector<Estimate> fraction(mesh_.size());
  view.seen_fractions(fraction);
  return fraction;
}

}  // namespace lrcs
