#pragma once
#include <cstdint>
#include <vector>

#include "lrcs/facet_returns.h"

namespace lrcs {

// What a grid leaves out if facets return more than all that its places met: none of these facets was met, so each is
// hidden, dark, or seen in places too few to be found. One pass over the facets, no rays.
// value: min(4 (brightest - largest), Sum over facets of (return - largest) area across the view / step^2), of facets
//   that may be lit and seen and return more than `largest` [1/sr, times places].
// error: the sum is sure. The other term is not: where they are seen in more than 4 places' area, bit by bit, the
//   chance that none was met is below e^-4 if places were independent.
class UnmetReturns {
 public:
  // Keeps a reference.
  explicit UnmetReturns(const Target& target);

  // side: a step of the grid [m].
  [[nodiscard]] double beyond(double largest, const Vec3& to_transmitter, const Vec3& to_receiver, double side);

 private:
  struct Excess {
    double most = 0.0, sum = 0.0;
  };
  void add_retro(std::uint32_t material);
  [[nodiscard]] Excess retro_excess(double largest, const Vec3& d, double enough) const;
  [[nodiscard]] Excess excess(double largest, const Vec3& to_transmitter, const Vec3& to_receiver);

  const Target& target_;
  FacetReturns returns_;
  std::vector<double> retro_;     // of each material, by the angle: no model knows directions along a facet
  double brightest_retro_ = 0.0;  // of the materials that facets have
};

}  // namespace lrcs
