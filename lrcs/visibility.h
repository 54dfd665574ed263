#pragma once
#include <memory>
#include <vector>

#include "base/estimate.h"
#include "base/vec3.h"
#include "lrcs/facet_tree.h"
#include "mesh/facet_mesh.h"

namespace lrcs {

// Which part of every facet the transmitter lights AND the receiver sees, exactly.
//
// Every facet is taken by itself: the facets nearer to the viewer are cut with its plane, projected along the direction
// into its own coordinates, and the area is measured where the number of such layers is zero (lrcs/layer_count.h).
// Nothing is asked of the mesh: open, non-manifold, self-intersecting targets and any number of parts are alike. Which
// side of a facet's plane a vertex lies on is decided exactly (lrcs/exact_height.h). domain: finite coordinates; unit
// directions. Coincident facets count once: the one whose front is seen, then the lower index. error: Estimate::bound,
// a few units in the last place times the facet's foreshortening and the reach of what is before it. check: closed
// forms, rays and metamorphic laws in tests/lrcs/visibility_test.cpp.
class Visibility {
 public:
  // Copies the geometry and builds what does not depend on directions.
  explicit Visibility(const FacetMesh& mesh);

  // value: fraction 0..1 of the facet's area that is lit from to_transmitter and seen from to_receiver (equal:
  // monostatic). shape: one a facet. A facet whose two sides face the one and the other, or that is seen edge-on, has
  // fraction 0. Safe to call from several threads at once; the result does not depend on their number.
  [[nodiscard]] std::vector<Estimate> seen_fraction(const Vec3& to_transmitter, const Vec3& to_receiver) const;

 private:
  FacetMesh mesh_;                   // vertices of equal position merged, scaled by a power of two to a size near 1
  std::unique_ptr<FacetTree> tree_;  // its facets of non-zero area
};

}  // namespace lrcs
