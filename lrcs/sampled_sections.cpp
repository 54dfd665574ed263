#include "lrcs/sampled_sections.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lrcs/embree_scene.h"
#include "lrcs/row_spread.h"
#include "lrcs/row_sums.h"
#include "lrcs/touching_facets.h"

namespace lrcs {
namespace {

// What it costs, in seconds on one core of 2020: only the ratio counts. A ray through a larger tree takes longer. The
// exact way is put low (it takes up to ten times that where outlines are many), for it leaves no error.
double exact_cost(double facets) {
  return 4e-3 + 0.15e-6 * facets;
}
double grid_cost(double facets, double size) {
  return size * size * 10e-9 * std::pow(facets / 5e3, 0.35);
}

// The bound falls as size^-3/2; for a smooth target it is about 15 times that, of sigma.
double size_for(double relative, double bound_of_one_place) {
  return std::pow(bound_of_one_place / relative, 2.0 / 3.0);
}
constexpr double smooth = 15.0, usual = 30.0;

// Sampled and exact cost alike only if sampling takes this part: a grid may not be enough.
constexpr double reserve = 1.5;

bool pays(double facets, double size) {
  return reserve * grid_cost(facets, size) < exact_cost(facets);
}

// Of two independent estimates; weights as if the bounds fell as they should.
SampledSection combined(const SampledSection& a, double size_a, const SampledSection& b, double size_b) {
  const double part = 1.0 / (1.0 + std::pow(size_b / size_a, 3.0)), rest = 1.0 - part;
  return {{part * a.sigma.value + rest * b.sigma.value, std::hypot(part * a.sigma.bound, rest * b.sigma.bound)},
          part * a.seen_area + rest * b.seen_area};
}

}  // namespace

SampledSections::SampledSections(const Target& target, double relative)
    : target_(target),
      relative_(relative),
      scene_(std::make_unique<const EmbreeScene>(target.mesh)),
      touching_(std::make_unique<const TouchingFacets>(target, *scene_)),
      grids_(target.mesh) {}

SampledSections::~SampledSections() = default;

bool SampledSections::may_pay(const Target& target, double relative) {
  return relative > 5.0 * float_error && target.mesh.size() > 0 &&
         pays(static_cast<double>(target.mesh.size()), size_for(relative, smooth));
}

SampledSection SampledSections::cast(const Vec3& to_transmitter, const Vec3& to_receiver, double size) const {
  std::unique_ptr<RowSums>& sums = sums_.local();
  if (!sums) sums = std::make_unique<RowSums>(target_, *scene_, *touching_);
  const RowGrid grid = grids_.over(to_receiver, size);
  const auto& rows = sums->cast(grid, to_transmitter);
  const double side = grid.step / grids_.placement().scale * target_.mesh.metres_per_unit;
  const Estimate sum = sum_of_rows(rows, sums->largest());
  const double around = 4.0 * std::numbers::pi * side * side;
  double area = 0.0;
  for (const RowSum& row : rows) area += row.area;
  return {{around * sum.value, around * (sum.bound + float_error * sum.value)}, side * side * area};
}

std::optional<SampledSection> SampledSections::section(const Vec3& to_transmitter, const Vec3& to_receiver) const {
  const auto facets = static_cast<double>(target_.mesh.size());
  const double least = 32.0, farther = 1.15;
  double size = std::max(least, size_for(relative_, usual));
  if (!pays(facets, size)) return std::nullopt;
  SampledSection found = cast(to_transmitter, to_receiver, size);
  constexpr int more = 3;
  for (int attempt = 0; found.sigma.bound > relative_ * found.sigma.value; ++attempt) {
    if (attempt == more || found.sigma.value <= 0.0) return std::nullopt;
    const double next = farther * size * size_for(relative_, found.sigma.bound / found.sigma.value);
    if (!pays(facets, next)) return std::nullopt;
    const SampledSection finer = cast(to_transmitter, to_receiver, next);
    found = combined(found, size, finer, next);
    size = next;
  }
  return found.sigma.value > 0.0 ? std::optional(found) : std::nullopt;
}

}  // namespace lrcs
