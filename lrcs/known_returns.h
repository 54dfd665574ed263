#pragma once
#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "lrcs/facet_returns.h"

namespace lrcs {

// FacetReturns of facets met again and again, as along rows of a picture: those met of late are remembered.
class KnownReturns {
 public:
  // Keeps a reference.
  explicit KnownReturns(const Target& target) : returns_(target), known_(facets) {}

  void look_along(const Vec3& to_transmitter, const Vec3& to_receiver) {
    returns_.look_along(to_transmitter, to_receiver);
    std::fill(known_.begin(), known_.end(), Known{});
  }

  [[nodiscard]] double of(std::uint32_t facet) { return known(facet).value; }

  [[nodiscard]] double most(std::uint32_t facet) const { return returns_.most(facet); }

  [[nodiscard]] double range_in_plane_of(std::uint32_t facet) {
    Known& of = known(facet);
    if (of.range < 0.0) of.range = returns_.range_in_plane_of(facet);
    return of.range;
  }

 private:
  struct Known {
    std::uint32_t facet = std::numeric_limits<std::uint32_t>::max();
    double value = 0.0;
    double range = -1.0;  // not yet asked for
  };

  Known& known(std::uint32_t facet) {
    Known& known = known_[facet % facets];
    if (known.facet != facet) known = {facet, returns_.of(facet), -1.0};
    return known;
  }

  static constexpr std::size_t facets = 1024;
  FacetReturns returns_;
  std::vector<Known> known_;  // at the facet's number, modulo
};

}  // namespace lrcs
