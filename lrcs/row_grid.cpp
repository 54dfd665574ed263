#include "lrcs/row_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lrcs/askew_axes.h"

namespace lrcs {
namespace {

constexpr std::uint32_t cells = 16;  // along each axis

constexpr double far = std::numeric_limits<double>::infinity();

struct Corners {
  Vec3 low = Vec3::Constant(far), high = Vec3::Constant(-far);
};

std::uint32_t cell_of(const Vec3& placed) {
  std::uint32_t cell = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double along = (placed[axis] + 0.5) * cells;
    cell = cells * cell + static_cast<std::uint32_t>(std::clamp(along, 0.0, cells - 1.0));
  }
  return cell;
}

}  // namespace

RowGrids::RowGrids(const FacetMesh& mesh) : placement_(mesh) {
  std::vector<Corners> of_cell(std::size_t{cells} * cells * cells);
  for (const auto& facet : mesh.facets)
    for (const std::uint32_t k : facet) {
      const Vec3 p = placement_.placed(mesh.positions[k]);
      Corners& box = of_cell[cell_of(p)];
      box.low = box.low.cwiseMin(p);
      box.high = box.high.cwiseMax(p);
    }
  for (const Corners& box : of_cell)
    if (box.low.x() <= box.high.x()) boxes_.push_back({0.5 * (box.low + box.high), 0.5 * (box.high - box.low)});
}

RowGrid RowGrids::over(const Vec3& to_viewer, double size) const {
  RowGrid grid;
  grid.toward = to_viewer;
  const AskewAxes across(to_viewer);
  grid.right = across.right;
  grid.up = across.up;
  const std::array<Vec3, 3> axes{grid.right, grid.up, grid.toward};
  std::array<double, 3> low{}, high{};
  for (std::size_t k = 0; k < 3; ++k) {
    low[k] = far;
    high[k] = -far;
    for (const Box& box : boxes_) {
      const double middle = axes[k].dot(box.middle), half = axes[k].cwiseAbs().dot(box.half);
      low[k] = std::min(low[k], middle - half);
      high[k] = std::max(high[k], middle + half);
    }
    low[k] -= 0.5 * float_error;
    high[k] += 0.5 * float_error;
  }
  grid.step = std::sqrt((high[0] - low[0]) * (high[1] - low[1])) / size;
  const auto steps = [&](int axis) {
    return static_cast<std::uint32_t>(std::ceil((high[axis] - low[axis]) / grid.step));
  };
  grid.columns = steps(0) + 1;  // the shift moves places by up to a step
  grid.rows = steps(1);
  grid.corner = (low[0] - grid.step) * grid.right + low[1] * grid.up + high[2] * grid.toward;
  return grid;
}

}  // namespace lrcs
