#include "bench/sweep_speed.h"

#include <fmt/format.h>

#include <vector>

#include "bench/bumpy_sphere.h"
#include "bench/copy_bandwidth.h"
#include "bench/icosphere.h"
#include "bench/measurement.h"
#include "bench/median.h"
#include "bench/stopwatch.h"
#include "brdf/library.h"
#include "lrcs/sweep.h"

namespace lrcs {
namespace {

Target of_metal_skin(FacetMesh mesh) {
  Target target{std::move(mesh), {*find_in_library("metal-skin-5p")}, {}, Sides::both};
  target.material.assign(target.mesh.size(), 0);
  return target;
}

double sweep_seconds(const Target& target, std::size_t directions, std::size_t threads) {
  std::vector<Aspect> aspects;
  for (const AspectAngles& angles : seeded_directions(directions)) aspects.push_back(aspect_of(angles, {}));
  return seconds_of([&] { static_cast<void>(run_sweep(target, aspects, threads)); });
}

}  // namespace

std::string thread_scaling(std::size_t directions, int runs) {
  const Target target = of_metal_skin(bumpy_sphere(180));
  std::vector<double> one, two;
  for (int run = 0; run < runs; ++run) {
    one.push_back(sweep_seconds(target, directions, 1));
    two.push_back(sweep_seconds(target, directions, 2));
  }
  return fmt::format(
      "thread scaling: {} directions of bumpy-129k, built anew: {:.2f} s with 1 thread, {:.2f} s with 2: {:.2f} "
      "times\n",
      directions, median(one), median(two), median(one) / median(two));
}

std::string convex_sweep_speed(std::uint32_t subdivisions, std::size_t directions, int runs) {
  const Target target = of_metal_skin(icosphere(subdivisions));
  const auto facets = static_cast<double>(target.mesh.size());
  std::vector<double> built, swept;
  for (int run = 0; run < runs; ++run) {
    built.push_back(sweep_seconds(target, 1, 1));
    swept.push_back(sweep_seconds(target, 1 + directions, 1));
  }
  const double rate = facets * static_cast<double>(directions) / (median(swept) - median(built));
  constexpr std::size_t large = std::size_t{256} << 20U;
  constexpr double bytes_a_facet = 32.0;
  const double bandwidth = copy_bandwidth(large);
  return fmt::format(
      "convex sweep: {} facets, {} directions: {:.3g} facet-directions a second ({:.2f} s once to check that it is "
      "convex left out); copy bandwidth {:.1f} GB/s / 32 bytes = {:.3g} a second: {:.2f} times\n",
      target.mesh.size(), directions, rate, median(built), 1e-9 * bandwidth, bandwidth / bytes_a_facet,
      rate * bytes_a_facet / bandwidth);
}

}  // namespace lrcs
