#pragma once
#include <cstdint>
#include <optional>
#include <span>

#include "base/estimate.h"
#include "lrcs/cross_section.h"

namespace lrcs {

// Which share of each curved facet's surface is lit and seen, as far as it faces a pair of directions.
// source: docs/methods.md, section 8, "Where the surface turns away".
class SurfaceFractions {
 public:
  using Facet = CurvedSurface::Facet;

  // The cosines that a direction has on a facet, as far as their signs go.
  struct Range {
    double least, most;

    [[nodiscard]] double least_of(double side) const { return side > 0.0 ? least : -most; }
  };
  struct Facing {
    Range i, r;

    // Do all of a facet's normals lie on one side, for either direction?
    [[nodiscard]] bool is_whole() const { return i.least * i.most > 0.0 && r.least * r.most > 0.0; }
    [[nodiscard]] bool is_clear(double side) const { return i.least_of(side) > 0.0 && r.least_of(side) > 0.0; }
    [[nodiscard]] bool may_be_lit_and_seen(double side) const {
      return i.least_of(-side) < 0.0 && r.least_of(-side) < 0.0;
    }
  };

  // seen: of each flat facet. All but the directions' copies are kept by reference.
  SurfaceFractions(const Target& target, std::span<const Estimate> seen, const Vec3& wi, const Vec3& wr)
      : target_(target), seen_(seen), wi_(wi), wr_(wr) {}

  [[nodiscard]] Facing facing_of(const Facet& facet) const;

  // Of a side of a facet. Near to where the surface turns away, flat facets stand in each other's light as the surface
  // does not: there, that of the nearest facets clear of it, if they are seen whole and the flat facet mostly is, or is
  // turned away itself. What the two differ by is not known better.
  [[nodiscard]] Estimate fraction_of(const Facet& facet, const Facing& facing, double side) const;

 private:
  [[nodiscard]] bool faces(std::size_t facet, double side) const;
  // The mean of the nearest facets that are clear of where the surface turns away, on the way over those that are not.
  [[nodiscard]] std::optional<Estimate> fraction_beside(const Facet& facet, double side) const;
  [[nodiscard]] const Facet& curved(std::uint32_t facet) const {
    return target_.curved.facets()[target_.curved.place_of(facet)];
  }

  const Target& target_;
  std::span<const Estimate> seen_;
  Vec3 wi_, wr_;
};

}  // namespace lrcs
