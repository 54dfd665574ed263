#include "bench/work_precision.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <random>
#include <variant>

#include "base/direction.h"
#include "bench/embree_rays.h"
#include "bench/median.h"
#include "brdf/library.h"
#include "lrcs/visibility.h"

namespace lrcs::bench {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

struct Totals {
  double seen_area = 0.0, lambert = 0.0, metal_skin = 0.0;
};

Totals total(const FacetMesh& mesh, const Vec3& toward, const std::vector<double>& seen, bool fronts_alone) {
  static const Material metal = *find_in_library("metal-skin-5p");
  Totals sum;
  for (std::size_t f = 0; f < mesh.size(); ++f) {
    const double cosine = mesh.normals[f].dot(toward);
    if (seen[f] == 0.0 || (fronts_alone && cosine <= 0.0)) continue;
    const double area = mesh.areas[f] * seen[f], c = std::abs(cosine);
    sum.seen_area += area * c;
    sum.lambert += area * c * c;
    sum.metal_skin += area * std::visit([c](const auto& model) { return model.f_cos_cos_retro(c); }, metal.brdf);
  }
  return sum;
}

double relative(double value, double exact) {
  return exact == 0.0 ? 0.0 : std::abs(value - exact) / exact;
}

struct Method {
  std::string name;
  bool fronts_alone;
  std::function<std::vector<double>(const Vec3&)> seen;
};

std::vector<Method> methods(const Visibility& visibility, const EmbreeRays& embree, bool short_run) {
  std::vector<Method> all;
  all.push_back({"exact", false, [&](const Vec3& d) {
                   const auto estimates = visibility.seen_fraction(d, d);
                   std::vector<double> seen(estimates.size());
                   std::transform(estimates.begin(), estimates.end(), seen.begin(),
                                  [](const Estimate& e) { return e.value; });
                   return seen;
                 }});
  for (unsigned side = 1; side <= (short_run ? 4U : 16U); side *= 2)
    all.push_back({side == 1 ? one_ray_a_facet : fmt::format("{} Embree rays a facet", side * side), true,
                   [&embree, side](const Vec3& d) { return embree.from_facets(d, side); }});
  for (unsigned side = 256; side <= (short_run ? 512U : 4096U); side *= 2)
    all.push_back({fmt::format("ray grid {}^2", side), false,
                   [&embree, side](const Vec3& d) { return embree.from_pixels(d, side); }});
  return all;
}

}  // namespace

std::vector<Measurement> measure(const std::string& name, const FacetMesh& mesh, unsigned directions, bool short_run) {
  const Visibility visibility(mesh);
  const EmbreeRays embree(mesh);
  const auto all = methods(visibility, embree, short_run);
  std::mt19937_64 random(2026);
  std::uniform_real_distribution<double> within(-1.0, 1.0);
  std::vector<Measurement> measured;
  constexpr unsigned repetitions = 3;
  for (unsigned k = 0; k < directions; ++k) {
    const double azimuth = 180.0 * within(random), elevation = 90.0 * within(random);
    const Vec3 toward = direction_of({azimuth, elevation});
    std::vector<std::vector<double>> times(all.size());
    std::vector<std::vector<double>> seen(all.size());
    for (unsigned r = 0; r < repetitions; ++r)
      for (std::size_t m = 0; m < all.size(); ++m) {
        const auto start = Clock::now();
        seen[m] = all[m].seen(toward);
        times[m].push_back(seconds_since(start));
      }
    for (std::size_t m = 0; m < all.size(); ++m) {
      const Totals exact = total(mesh, toward, seen[0], all[m].fronts_alone);
      const Totals its = total(mesh, toward, seen[m], all[m].fronts_alone);
      measured.push_back({name, mesh.size(), azimuth, elevation, all[m].name, median(times[m]),
                          relative(its.seen_area, exact.seen_area), relative(its.lambert, exact.lambert),
                          relative(its.metal_skin, exact.metal_skin)});
    }
  }
  return measured;
}

}  // namespace lrcs::bench
