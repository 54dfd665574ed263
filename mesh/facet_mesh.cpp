#include "mesh/facet_mesh.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <cmath>
#include <span>

#include "base/expansion.h"
#include "base/large_pages.h"
#include "mesh/facet_crosses.h"
#include "mesh/product_difference.h"

namespace lrcs {
namespace {

// p q - r s.
double difference_of_products(Unrounded p, Unrounded q, Unrounded r, Unrounded s) {
  const auto [quick, least] =
      product_difference(p, q, r, s, product_of(p.value, q.value), product_of(r.value, s.value));
  if (std::abs(quick) >= least) return quick;
  Expansion<16> exact;
  for (const double a : {p.value, p.error})
    for (const double b : {q.value, q.error}) exact.add_product(a, b);
  for (const double a : {r.value, r.error})
    for (const double b : {s.value, s.error}) exact.add_product(-a, b);
  return exact.rounded();
}

// Vec3::stableNorm(), without its loop over blocks.
double length_of(const Vec3& v) {
  const double most = v.cwiseAbs().maxCoeff();
  if (!(most > 0x1p-1000 && most < 0x1p1000)) return v.stableNorm();
  const Vec3 scaled = v * (1.0 / most);
  return most * std::sqrt((scaled.x() * scaled.x() + scaled.y() * scaled.y()) + scaled.z() * scaled.z());
}

}  // namespace

Vec3 facet_cross(const Vec3& a, const Vec3& b, const Vec3& c) {
  std::array<Unrounded, 3> p{};
  std::array<Unrounded, 3> q{};
  for (int k = 0; k < 3; ++k) {
    p[static_cast<std::size_t>(k)] = sum_of(b[k], -a[k]);
    q[static_cast<std::size_t>(k)] = sum_of(c[k], -a[k]);
  }
  return {difference_of_products(p[1], q[2], p[2], q[1]), difference_of_products(p[2], q[0], p[0], q[2]),
          difference_of_products(p[0], q[1], p[1], q[0])};
}

void measure_facets(FacetMesh& mesh) {
  if (mesh.normals.size() != mesh.size()) {
    reserve_large(mesh.normals, mesh.size());
    reserve_large(mesh.areas, mesh.size());
    mesh.normals.resize(mesh.size());
    mesh.areas.resize(mesh.size());
  }
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mesh.size(), 4096), [&](const auto& range) {
    const std::span normals = std::span(mesh.normals).subspan(range.begin(), range.size());
    facet_crosses(mesh.positions, std::span(mesh.facets).subspan(range.begin(), range.size()), normals);
    for (std::size_t k = range.begin(); k < range.end(); ++k) {
      const double length = length_of(mesh.normals[k]);
      mesh.areas[k] = 0.5 * length * mesh.metres_per_unit * mesh.metres_per_unit;
      mesh.normals[k] = length > 0.0 ? Vec3(mesh.normals[k] / length) : Vec3::Zero();
    }
  });
}

double diagonal_of(const FacetMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const auto& facet : mesh.facets)
    for (const std::uint32_t corner : facet) box.extend(mesh.positions[corner]);
  return box.isEmpty() ? 0.0 : box.diagonal().stableNorm();
}

}  // namespace lrcs
