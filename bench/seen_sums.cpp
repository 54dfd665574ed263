#include "bench/seen_sums.h"

#include <cmath>
#include <numbers>
#include <variant>

#include "base/compensated_sum.h"
#include "brdf/lambert.h"
#include "brdf/library.h"

namespace lrcs {

namespace {

// Calls add(facet, returned): what every front facet would return if all of it were seen.
template <class Add>
void visit_fronts(const FacetMesh& mesh, const Vec3& to_viewer, const Add& add) {
  const Lambert lambert(0.5);
  const Wu& wu = std::get<Wu>(find_in_library("metal-skin-5p")->brdf);
  for (std::size_t f = 0; f < mesh.size(); ++f) {
    const double cosine = mesh.normals[f].dot(to_viewer);
    if (cosine <= 0.0) continue;
    const double around = 4.0 * std::numbers::pi * mesh.areas[f];
    add(f, SeenSums{around * lambert.f_cos_cos_retro(cosine), around * wu.f_cos_cos_retro(cosine),
                    mesh.areas[f] * cosine});
  }
}

}  // namespace

SeenSums seen_sums(const FacetMesh& mesh, const std::vector<double>& seen_fraction, const Vec3& to_viewer) {
  CompensatedSum sigma_lambert, sigma_wu, seen_area;
  visit_fronts(mesh, to_viewer, [&](std::size_t f, const SeenSums& all) {
    sigma_lambert.add(seen_fraction[f] * all.sigma_lambert);
    sigma_wu.add(seen_fraction[f] * all.sigma_wu);
    seen_area.add(seen_fraction[f] * all.seen_area);
  });
  return {sigma_lambert.value(), sigma_wu.value(), seen_area.value()};
}

SeenSums one_ray_deviation(const FacetMesh& mesh, const std::vector<double>& seen_fraction, const Vec3& to_viewer) {
  SeenSums variance;
  visit_fronts(mesh, to_viewer, [&](std::size_t f, const SeenSums& all) {
    const double of_facet = seen_fraction[f] * (1.0 - seen_fraction[f]);
    variance.sigma_lambert += of_facet * all.sigma_lambert * all.sigma_lambert;
    variance.sigma_wu += of_facet * all.sigma_wu * all.sigma_wu;
    variance.seen_area += of_facet * all.seen_area * all.seen_area;
  });
  return {std::sqrt(variance.sigma_lambert), std::sqrt(variance.sigma_wu), std::sqrt(variance.seen_area)};
}

SeenSums quotient(const SeenSums& part, const SeenSums& whole) {
  return {part.sigma_lambert / whole.sigma_lambert, part.sigma_wu / whole.sigma_wu, part.seen_area / whole.seen_area};
}

SeenSums relative_errors(const SeenSums& found, const SeenSums& truth) {
  const auto relative = [](double a, double b) { return std::abs(a - b) / b; };
  return {relative(found.sigma_lambert, truth.sigma_lambert), relative(found.sigma_wu, truth.sigma_wu),
          relative(found.seen_area, truth.seen_area)};
}

}  // namespace lrcs
