#pragma once
#include <cstdint>
#include <vector>

#include "bench/pixel_grid.h"
#include "lrcs/embree_scene.h"

namespace lrcs {

// Parallel rays from the viewer through the middles of a square grid's pixels: the facet that each meets first gets the
// pixel's area. Closest hits in packets of 16, of 4 x 4 pixels.
class RayGrid {
 public:
  // Keeps references.
  RayGrid(const FacetMesh& mesh, const EmbreeScene& scene, const PixelGrids& grids);

  // `pixels` rays along the longer side of what the viewer sees.
  void cast(const Vec3& to_viewer, std::uint32_t pixels);

  // Of the last cast. shape: one a facet; 0 for those that turn their back.
  [[nodiscard]] std::vector<double> seen_fraction() const;

 private:
  const FacetMesh& mesh_;
  const EmbreeScene& scene_;
  const PixelGrids& grids_;
  PixelGrid grid_;
  std::vector<std::uint32_t> pixels_;  // of each facet
};

}  // namespace lrcs
