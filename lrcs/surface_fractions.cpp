#include "lrcs/surface_fractions.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lrcs {
namespace {

SurfaceFractions::Range range_of(const CurvedSurface::Facet& facet, const Vec3& w) {
  const double middle = facet.axis.dot(w);
  if (std::abs(middle) > facet.spread || facet.planar) return {middle, middle};
  SurfaceFractions::Range range{middle, middle};
  for (const Vec3& normal : facet.patch.normal) {
    const double there = middle + CurvedSurface::beyond_places * (normal.dot(w) - middle);
    range.least = std::min(range.least, there);
    range.most = std::max(range.most, there);
  }
  return range;
}

}  // namespace

SurfaceFractions::Facing SurfaceFractions::facing_of(const Facet& facet) const {
  const Range of_i = range_of(facet, wi_);
  return {of_i, wi_ == wr_ ? of_i : range_of(facet, wr_)};
}

bool SurfaceFractions::faces(std::size_t facet, double side) const {
  const Vec3& n = target_.mesh.normals[facet];
  return side * n.dot(wi_) > 0.0 && side * n.dot(wr_) > 0.0;
}

Estimate SurfaceFractions::fraction_of(const Facet& facet, const Facing& facing, double side) const {
  const bool is_faced = faces(facet.facet, side);
  const Estimate own = is_faced ? seen_[facet.facet] : Estimate{};
  if (is_faced && facing.is_clear(side)) return own;
  const auto beside = fraction_beside(facet, side);
  if (!beside) return own;
  const bool is_edge_on = own.value == 0.0 && own.bound == 1.0;
  if (!is_faced || is_edge_on) return *beside;
  const double apart = std::abs(beside->value - own.value);
  const double value = beside->value == 1.0 && own.value > 0.5 ? 1.0 : own.value;
  return {value, std::max(own.bound, apart)};
}

std::optional<Estimate> SurfaceFractions::fraction_beside(const Facet& facet, double side) const {
  constexpr std::size_t most_rings = 8;
  std::vector<std::uint32_t> met{facet.facet};
  std::size_t first = 0;
  for (std::size_t ring = 0; ring < most_rings; ++ring) {
    Estimate sum;
    double count = 0.0;
    for (const std::size_t last = met.size(); first < last; ++first)
      for (const std::uint32_t k : curved(met[first]).adjacent) {
        if (k == CurvedSurface::none || std::find(met.begin(), met.end(), k) != met.end()) continue;
        const Facing facing = facing_of(curved(k));
        if (!facing.is_clear(side) || !faces(k, side)) {
          if (facing.may_be_lit_and_seen(side)) met.push_back(k);
          continue;
        }
        sum.value += seen_[k].value;
        sum.bound += seen_[k].bound;
        count += 1.0;
      }
    if (count > 0.0) {
      const double mean = sum.value / count;
      // Where a shadow's edge runs that near, the facet may lie on either side of it.
      const bool is_mixed = mean > 0.0 && mean < 1.0;
      return Estimate{mean, is_mixed ? std::max(mean, 1.0 - mean) : sum.bound / count};
    }
  }
  return std::nullopt;
}

}  // namespace lrcs
