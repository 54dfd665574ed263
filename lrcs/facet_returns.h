#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "lrcs/cross_section.h"

namespace lrcs {

// What facets return for a pair of directions, for as much of them as is lit and seen.
// value: f_r cos_i cos_r / |cos_r| [1/sr]: times 4 pi and the area across the receiver's view it is the share of sigma.
//   0 for backs where only fronts reflect, and for facets that the receiver sees edge-on.
class FacetReturns {
 public:
  // Keeps a reference.
  explicit FacetReturns(const Target& target) : target_(target) {}

  void look_along(const Vec3& to_transmitter, const Vec3& to_receiver);

  // domain: both directions on one side of the facet.
  [[nodiscard]] double of(std::uint32_t facet) const;

  // The same; the most that either side may return where the transmitter sees it edge-on, as far as doubles tell.
  // Of a model that throws NotMeasured, the value it supposes then: perhaps no one sees the facet (brdf/brdf.h).
  [[nodiscard]] double most(std::uint32_t facet) const;

  // Of a facet of this material, supposed likewise. n: its normal, toward the receiver.
  [[nodiscard]] double of_material(std::size_t material, const Vec3& n) const;

  // The largest difference between this and what any other facet in its plane may return, of whatever material.
  [[nodiscard]] double range_in_plane_of(std::uint32_t facet) const;

 private:
  const Target& target_;
  Vec3 wi_, wr_;
  using Models = std::vector<std::function<double(const Vec3& n)>>;  // one a material: f_r cos_i cos_r of a normal
  [[nodiscard]] double value(const Models& models, std::size_t material, const Vec3& n) const;
  [[nodiscard]] double value(const Models& models, std::uint32_t facet) const;
  Models models_, supposed_;
};

}  // namespace lrcs
