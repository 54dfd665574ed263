#pragma once
#include <cstdint>
#include <vector>

#include "base/splitmix64.h"
#include "lrcs/placement.h"

namespace lrcs {

// A lattice of places across what a viewer sees, in rows: x along a row and y across rows count steps. Place c of row r
// is at x = c + offset(r), y = r + 1/2. frame: that of Placement. Rows lie along AskewAxes. Each pair of rows is
// shifted by an amount of its own, as if at random, its second row by half a step more: so pairs err as if
// independently, without a bias along any edge, which is what tells the error (lrcs/row_spread.h). Shifted by 1/4 to
// 3/4 only, rows err together along edges that lie along columns: 1 of 1,485 grids of 300^2 on starlink had 1.9 times
// its bound, now at most 0.75. A regular shift may fall in step with edges: by the golden ratio it had up to ten times
// the error on hubble.
struct RowGrid {
  Vec3 right, up, toward;  // unit
  Vec3 corner;             // x = y = 0, at the height of what is nearest to the viewer
  double step = 0.0;       // between places of a row, and between rows
  std::uint32_t columns = 0, rows = 0;

  // Of a row's places, 0..1 [steps].
  [[nodiscard]] static double offset(std::uint32_t row) {
    const double first = static_cast<double>(splitmix64(row / 2 + std::uint64_t{1}) >> 11U) * 0x1p-53;
    if (row % 2 == 0) return first;
    return first < 0.5 ? first + 0.5 : first - 0.5;
  }
};

// Lays row grids over a target, direction by direction.
class RowGrids {
 public:
  explicit RowGrids(const FacetMesh& mesh);

  // About size x size places over the box of what is seen.
  [[nodiscard]] RowGrid over(const Vec3& to_viewer, double size) const;

  [[nodiscard]] const Placement& placement() const { return placement_; }

 private:
  struct Box {
    Vec3 middle, half;
  };
  Placement placement_;
  std::vector<Box> boxes_;  // placed: of the vertices in cells of a coarse grid
};

}  // namespace lrcs
