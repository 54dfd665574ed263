#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "lrcs/placement.h"

namespace lrcs {

// Square pixels over a placed target as a viewer sees it, without room to spare. frame: that of Placement.
// Its rows lie along AskewAxes.
struct PixelGrid {
  Vec3 right, up, toward;  // unit
  Vec3 corner;             // of the lowest left pixel, at the height of what is nearest to the viewer
  double depth = 0.0;      // from there to what is farthest
  double pixel = 0.0;      // side
  std::uint32_t columns = 0, rows = 0;
};

// Lays pixel grids over a target, direction by direction.
class PixelGrids {
 public:
  explicit PixelGrids(const FacetMesh& mesh);

  // `pixels` of them along the longer side.
  [[nodiscard]] PixelGrid over(const Vec3& to_viewer, std::uint32_t pixels) const;

  [[nodiscard]] const Placement& placement() const { return placement_; }

 private:
  Placement placement_;
  Eigen::Matrix<float, Eigen::Dynamic, 3> positions_;  // placed
};

// From how many pixels every facet has: the seen fraction of every facet that faces the viewer; others have 0.
[[nodiscard]] std::vector<double> seen_fraction(const FacetMesh& mesh, const std::vector<std::uint32_t>& pixels,
                                                double pixel_area, const Vec3& to_viewer);

}  // namespace lrcs
