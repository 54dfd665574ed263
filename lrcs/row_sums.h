#pragma once
#include <cstdint>
#include <vector>

#include "lrcs/grazing_light.h"
#include "lrcs/known_returns.h"
#include "lrcs/row_grid.h"
#include "lrcs/row_rays.h"
#include "lrcs/touching_facets.h"

namespace lrcs {

// What is seen along one row: sums over its places.
struct RowSum {
  double value = 0.0;  // of what the facets seen return (FacetReturns)
  double area = 0.0;   // of 1 where a facet is seen and lit
  double doubt = 0.0;  // of what might return more or less (TouchingFacets, GrazingLight)
};

// Casts the rays of a grid, and sums along its rows.
class RowSums {
 public:
  // Keeps references.
  RowSums(const Target& target, const EmbreeScene& scene, const TouchingFacets& touching);

  // shape: one a row of the grid; valid until the next call.
  const std::vector<RowSum>& cast(const RowGrid& grid, const Vec3& to_transmitter);

  // The largest value at any place of the last grid.
  [[nodiscard]] double largest() const { return largest_; }

 private:
  void cast_tile(std::uint32_t row, std::uint32_t column);

  RowRays rays_;
  KnownReturns returns_;
  const TouchingFacets& touching_;
  GrazingLight grazing_;
  bool bistatic_ = false;
  std::vector<RowSum> sums_;
  double largest_ = 0.0;
};

}  // namespace lrcs
