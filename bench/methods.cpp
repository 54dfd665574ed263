#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "bench/embree_rays.h"
#include "bench/method.h"
#include "bench/peak_memory.h"
#include "bench/ray_grid.h"
#include "bench/stopwatch.h"
#include "bench/z_buffer.h"
#include "brdf/library.h"
#include "lrcs/cross_section.h"
#include "lrcs/sampled_sections.h"

namespace lrcs {
namespace {

const Vec3 first_look = Vec3(1.0, 2.0, 3.0).normalized();

Building building(const std::string& what, const std::function<void()>& build, const std::function<void()>& look) {
  Building made{what};
  made.bytes = peak_growth([&] {
    made.seconds = seconds_of(build);
    look();
  });
  return made;
}

std::vector<double> values(const std::vector<Estimate>& estimates) {
  std::vector<double> result;
  result.reserve(estimates.size());
  for (const Estimate& e : estimates) result.push_back(e.value);
  return result;
}

struct Exact {
  std::unique_ptr<Visibility> visibility;
  std::vector<Estimate> seen;
  Target target;
  CrossSection section;

  void look(const Vec3& d) {
    visibility->seen_fraction(d, d, seen);
    cross_section(target, seen, d, d, section);
  }
  [[nodiscard]] SeenSums sums(const Vec3& d) const {
    SeenSums sums = seen_sums(target.mesh, values(seen), d);
    sums.sigma_wu = section.sigma.value;
    return sums;
  }
};

// The seen fraction of every facet; and beside it the whole way to sigma and its bound, for one material.
std::shared_ptr<Exact> add_exact(Methods& methods, const FacetMesh& mesh) {
  auto state = std::make_shared<Exact>();
  methods.built.push_back(building(
      "exact", [&] { state->visibility = std::make_unique<Visibility>(mesh); },
      [&] { state->seen = state->visibility->seen_fraction(first_look, first_look); }));
  state->target = {mesh, {*find_in_library("metal-skin-5p")}, {}, Sides::front};
  state->target.material.assign(mesh.size(), 0);
  methods.deviation = [state](const Vec3& d) { return one_ray_deviation(state->target.mesh, values(state->seen), d); };
  constexpr double sums_rounding = 1e-9;  // of the bench's own sums, and far to spare
  const auto allowed = [](double /*deviation*/) { return sums_rounding; };
  methods.all.push_back({exact_family, "exact: seen fractions", "", 1.0,
                         [state](const Vec3& d) { state->visibility->seen_fraction(d, d, state->seen); },
                         [state](const Vec3& d) { return seen_sums(state->target.mesh, values(state->seen), d); },
                         allowed});
  methods.all.push_back({exact_to_sigma_family, "exact: cross section", "", 1.0,
                         [state](const Vec3& d) { state->look(d); }, [state](const Vec3& d) { return state->sums(d); },
                         allowed});
  return state;
}

// Six deviations, as if rays were not stratified; and what floats and touching facets may cost.
std::function<double(double)> allowed_of_rays(std::uint32_t rays) {
  return [rays](double deviation) { return 6.0 * deviation / std::sqrt(rays) + 1e-3; };
}

// As if every pixel on an outline as long as four sides went wrong.
std::function<double(double)> allowed_of_grid(std::uint32_t size) {
  return [size](double /*deviation*/) { return 4.0 / size; };
}

double pixels_of(std::uint32_t size) {
  return static_cast<double>(size) * size;
}

struct Embree {
  explicit Embree(const FacetMesh& mesh) : scene(mesh), rays(mesh, scene), grids(mesh), grid(mesh, scene, grids) {}
  EmbreeScene scene;
  EmbreeRays rays;
  PixelGrids grids;
  RayGrid grid;
};

// Rays from facets, and rays from the viewer, in one BVH.
void add_embree(Methods& methods, const FacetMesh& mesh, const Fineness& fineness) {
  std::shared_ptr<Embree> state;
  methods.built.push_back(building(
      "Embree", [&] { state = std::make_shared<Embree>(mesh); }, [&] { state->rays.cast(first_look, 1); }));
  for (const std::uint32_t strata : fineness.strata) {
    const std::uint32_t rays = strata * strata;
    methods.all.push_back({facet_rays_family, rays == 1 ? one_ray : fmt::format("Embree, {} rays a facet", rays),
                           rays == 1 ? "1 ray" : fmt::format("{} rays", rays), static_cast<double>(rays),
                           [state, strata](const Vec3& d) { state->rays.cast(d, strata); },
                           [state, &mesh](const Vec3& d) { return seen_sums(mesh, state->rays.seen_fraction(), d); },
                           allowed_of_rays(rays)});
  }
  for (const std::uint32_t size : fineness.grid_sizes)
    methods.all.push_back({ray_grid_family, fmt::format("ray grid, {0} x {0}", size), fmt::format("{}²", size),
                           pixels_of(size), [state, size](const Vec3& d) { state->grid.cast(d, size); },
                           [state, &mesh](const Vec3& d) { return seen_sums(mesh, state->grid.seen_fraction(), d); },
                           allowed_of_grid(size)});
}

struct Relative {
  std::shared_ptr<Exact> exact;
  std::unique_ptr<SampledSections> sampled;  // null: nothing is
  std::optional<SampledSection> section;     // none: exact

  void look(const Vec3& d) {
    section = sampled ? sampled->section(d, d) : std::nullopt;
    if (!section) exact->look(d);
  }
  [[nodiscard]] Estimate sigma() const { return section ? section->sigma : exact->section.sigma; }
  // That of exact is below what the bench's own sums round.
  [[nodiscard]] double bound() const { return section ? section->sigma.bound / section->sigma.value : 0.0; }
};

// What `accuracy: {relative: r}` takes: a grid, or the exact way. It knows one sum: sigma of metal-skin-5p.
void add_relative(Methods& methods, const std::shared_ptr<Exact>& exact) {
  for (const double relative : {1e-2, 1e-3, 1e-4}) {
    const auto state = std::make_shared<Relative>();
    state->exact = exact;
    if (SampledSections::may_pay(exact->target, relative))
      state->sampled = std::make_unique<SampledSections>(exact->target, relative, false);
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const std::string name = fmt::format("relative {:g}", relative);
    methods.all.push_back({relative_family, name, fmt::format("{:g}", relative), 1.0,
                           [state](const Vec3& d) { state->look(d); },
                           [state](const Vec3&) {
                             return SeenSums{unknown, state->sigma().value, unknown};
                           },
                           [relative](double /*deviation*/) { return relative; }, [state] { return state->bound(); }});
  }
}

void add_z_buffer(Methods& methods, const FacetMesh& mesh, const Fineness& fineness, const PrivateDisplay& display) {
  const auto grids = std::make_shared<PixelGrids>(mesh);
  std::shared_ptr<ZBuffer> buffer;
  methods.built.push_back(building(
      "z-buffers", [&] { buffer = std::make_shared<ZBuffer>(mesh, *grids, display, fineness.grid_sizes); },
      [&] { buffer->draw(first_look, fineness.grid_sizes.front()); }));
  for (const std::uint32_t size : fineness.grid_sizes)
    methods.all.push_back({z_buffer_family, fmt::format("z-buffer, {0} x {0}", size), fmt::format("{}²", size),
                           pixels_of(size), [buffer, grids, size](const Vec3& d) { buffer->draw(d, size); },
                           [buffer, &mesh](const Vec3& d) { return seen_sums(mesh, buffer->seen_fraction(), d); },
                           allowed_of_grid(size)});
}

}  // namespace

Methods methods_for(const FacetMesh& mesh, const Fineness& fineness, const PrivateDisplay* display) {
  Methods methods;
  const auto exact = add_exact(methods, mesh);
  add_embree(methods, mesh, fineness);
  add_relative(methods, exact);
  if (display != nullptr) add_z_buffer(methods, mesh, fineness, *display);
  return methods;
}

}  // namespace lrcs
