#include "lrcs/sampled_sections.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "lrcs/drawn_sums.h"
#include "lrcs/embree_scene.h"
#include "lrcs/row_spread.h"
#include "lrcs/row_sums.h"
#include "lrcs/touching_facets.h"
#include "lrcs/unmet_returns.h"
#include "lrcs/way_costs.h"

namespace lrcs {
namespace {

// The bound falls as size^-3/2; for a smooth target it is about this, times sigma, at one place.
constexpr double smooth = 9.5;

double size_for(double relative, double bound_of_one_place) {
  constexpr double least = 24.0;
  return std::max(least, std::pow(bound_of_one_place / relative, 2.0 / 3.0));
}

// Sampled and exact cost alike only if sampling takes this part: a grid may not be enough.
constexpr double reserve = 1.5;

// Of the surface across a view, both sides together, over what is seen: two layers a solid.
double depth_of(const FacetMesh& mesh, const Vec3& d, double seen_area) {
  double across = 0.0;
  for (std::size_t f = 0; f < mesh.size(); ++f) across += mesh.areas[f] * std::abs(mesh.normals[f].dot(d));
  return std::max(1.0, 0.5 * across / seen_area);
}

// Where a target is looked at from first, and how finely.
constexpr double first_look_size = 64.0;
std::vector<Vec3> first_looks() {
  std::vector<Vec3> looks{{3, 1, 2}, {-1, 2, 3}, {-2, -3, 1}, {1, -2, -3}, {2, -1, 3}, {-3, 2, -1}};
  for (Vec3& d : looks) d.normalize();
  return looks;
}

}  // namespace

struct SampledSections::Sample {
  double size = 0.0;    // of the grid
  double sigma = 0.0;   // [m^2]
  double spread = 0.0;  // RowTotal
  double doubt = 0.0;   // RowTotal, and that of floats
  double unmet = 0.0;   // UnmetReturns
  double seen_area = 0.0;
  [[nodiscard]] double bound() const { return spread + doubt + unmet; }
};

// Of two estimates, independent as far as rows spread; weights as if the bounds fell as they should.
SampledSections::Sample SampledSections::combined(const Sample& a, const Sample& b) {
  const double part = 1.0 / (1.0 + std::pow(b.size / a.size, 3.0));
  const auto mean = [&](double Sample::*of) { return part * a.*of + (1.0 - part) * b.*of; };
  const double spread = std::hypot(part * a.spread, (1.0 - part) * b.spread);
  return {b.size, mean(&Sample::sigma), spread, mean(&Sample::doubt), mean(&Sample::unmet), mean(&Sample::seen_area)};
}

struct SampledSections::Rays {
  explicit Rays(const Target& target) : scene(target.mesh), touching(target, scene) {}
  EmbreeScene scene;
  TouchingFacets touching;
};

struct SampledSections::Memory {
  explicit Memory(const Target& target) : drawn(target), unmet(target) {}
  DrawnSums drawn;
  UnmetReturns unmet;
  std::optional<RowSums> cast;
};

SampledSections::SampledSections(const Target& target, double relative, bool bistatic)
    : target_(target), relative_(relative), grids_(target.mesh) {
  try_out();
  if (!may_pay()) return;
  if (!bistatic && draws(first_size())) return;
  rays_ = std::make_unique<const Rays>(target);
  constexpr double little = 0.2;
  trusts_rays_ = doubt_of_rays() < little * relative;
}

SampledSections::~SampledSections() = default;

bool SampledSections::may_pay(const Target& target, double relative) {
  if (relative <= 5.0 * float_error || target.mesh.size() == 0) return false;
  const auto facets = static_cast<double>(target.mesh.size());
  const double size = size_for(relative, smooth);
  constexpr double deep = 2.0, few = 0.2;
  const double cost = std::min(drawing_cost(facets, size), rays_cost(facets, size, few));
  return reserve * cost < exact_cost(facets, deep);
}

bool SampledSections::may_pay() const {
  return is_cheaper(first_size(), false);
}

bool SampledSections::draws(double size) const {
  const auto facets = static_cast<double>(target_.mesh.size());
  return drawing_cost(facets, size) < rays_cost(facets, size, variety_);
}

bool SampledSections::is_cheaper(double size, bool bistatic) const {
  const auto facets = static_cast<double>(target_.mesh.size());
  const double rays = rays_cost(facets, size, variety_);
  const double cost = bistatic ? 2.0 * rays + unmet_cost(facets) : std::min(rays, drawing_cost(facets, size));
  return reserve * cost < exact_cost(facets, depth_);
}

double SampledSections::first_size() const {
  return size_for(relative_, bound_of_one_place_);
}

// How much of a sum is in doubt because rays may meet either of facets that touch.
double SampledSections::doubt_of_rays() const {
  if (rays_->touching.none()) return 0.0;
  RowSums cast(target_, rays_->scene, rays_->touching);
  double largest = 0.0;
  for (const Vec3& d : first_looks()) {
    double value = 0.0, doubt = 0.0;
    for (const RowSum& row : cast.cast(grids_.over(d, first_look_size), d)) {
      value += row.value;
      doubt += row.doubt;
    }
    if (value > 0.0) largest = std::max(largest, doubt / value);
  }
  return largest;
}

void SampledSections::try_out() {
  constexpr double size = first_look_size;
  bound_of_one_place_ = smooth;
  for (const Vec3& d : first_looks()) {
    const Sample found = sample(d, d, size);
    if (found.sigma <= 0.0) continue;
    const double bound = found.spread / found.sigma * std::pow(size, 1.5);
    bound_of_one_place_ = std::max(bound_of_one_place_, bound);
    variety_ = std::max(variety_, memory_.local()->drawn.variety());
    depth_ = std::max(depth_, depth_of(target_.mesh, d, found.seen_area));
  }
}

SampledSections::Sample SampledSections::sample(const Vec3& to_transmitter, const Vec3& to_receiver,
                                                double size) const {
  std::unique_ptr<Memory>& memory = memory_.local();
  if (!memory) memory = std::make_unique<Memory>(target_);
  const RowGrid grid = grids_.over(to_receiver, size);
  const bool drawn = to_transmitter == to_receiver && (!trusts_rays_ || draws(size));
  if (!drawn && !memory->cast) memory->cast.emplace(target_, rays_->scene, rays_->touching);
  const auto& rows = drawn ? memory->drawn.draw(grid) : memory->cast->cast(grid, to_transmitter);
  const double largest = drawn ? memory->drawn.largest() : memory->cast->largest();
  const double side = grid.step / grids_.placement().scale * target_.mesh.metres_per_unit;
  const RowTotal sum = sum_of_rows(rows, largest);
  const double around = 4.0 * std::numbers::pi * side * side;
  double area = 0.0;
  for (const RowSum& row : rows) area += row.area;
  return {size,
          around * sum.value,
          around * sum.spread,
          around * (sum.doubt + float_error * sum.value),
          around * memory->unmet.beyond(largest, to_transmitter, to_receiver, side),
          side * side * area};
}

std::optional<SampledSection> SampledSections::section(const Vec3& to_transmitter, const Vec3& to_receiver) const {
  const bool bistatic = to_transmitter != to_receiver;
  const double size = first_size();
  if (!is_cheaper(size, bistatic)) return std::nullopt;
  Sample found = sample(to_transmitter, to_receiver, size);
  constexpr int more = 3;
  constexpr double farther = 1.15;
  for (int attempt = 0; found.bound() > relative_ * found.sigma; ++attempt) {
    if (attempt == more || found.doubt >= relative_ * found.sigma) return std::nullopt;
    const double next = farther * found.size * std::pow(found.bound() / found.sigma / relative_, 2.0 / 3.0);
    if (!is_cheaper(next, bistatic)) return std::nullopt;
    found = combined(found, sample(to_transmitter, to_receiver, next));
  }
  if (found.sigma <= 0.0) return std::nullopt;
  return SampledSection{{found.sigma, found.bound()}, found.seen_area};
}

}  // namespace lrcs
