#pragma once
#include <array>
#include <cstdint>

#include "lrcs/seen_facet.h"
#include "lrcs/view_outline.h"

namespace lrcs {

// A quick look at a facet in the coordinates of a view: which outline edges certainly have nothing over it. What it
// does not rule out, FacetCut looks at properly.
class FacetSight {
 public:
  // `ids`: the facet's corners. `rounding`: of the view.
  void look_at(const SeenFacet& facet, const std::array<std::uint32_t, 3>& ids, double rounding);

  // Certainly beside the facet, or behind its plane.
  [[nodiscard]] bool certainly_passes_by(const OutlineEdge& edge) const;

 private:
  std::array<std::uint32_t, 3> ids_{};
  double x0_ = 0.0, y0_ = 0.0, z0_ = 0.0;  // of corner 0
  SeenFacet::OwnCoordinates own_{};        // change of u and v with x and y
  double z_u_ = 0.0, z_v_ = 0.0;           // change of z along the facet's plane
  double slack_ = 0.0;                     // error of u and v, for each 1 + |u| + |v|
  double height_slack_ = 0.0;              // the same of z over the plane
};

}  // namespace lrcs
