#include "bench/pixel_grid.h"

#include <algorithm>
#include <cmath>

#include "lrcs/askew_axes.h"

namespace lrcs {
namespace {

struct Range {
  double low, high;
  [[nodiscard]] double span() const { return high - low; }
};

Range range_along(const Eigen::Matrix<float, Eigen::Dynamic, 3>& positions, const Vec3& axis) {
  const Eigen::VectorXf heights = positions * axis.cast<float>();
  return {heights.minCoeff() - 0.5 * float_error, heights.maxCoeff() + 0.5 * float_error};
}

}  // namespace

PixelGrids::PixelGrids(const FacetMesh& mesh) : placement_(mesh), positions_(mesh.positions.size(), 3) {
  for (std::size_t k = 0; k < mesh.positions.size(); ++k)
    positions_.row(static_cast<Eigen::Index>(k)) = placement_.placed(mesh.positions[k]).cast<float>();
}

PixelGrid PixelGrids::over(const Vec3& to_viewer, std::uint32_t pixels) const {
  PixelGrid grid;
  grid.toward = to_viewer;
  const AskewAxes across(to_viewer);
  grid.right = across.right;
  grid.up = across.up;
  const Range x = range_along(positions_, grid.right), y = range_along(positions_, grid.up);
  const Range z = range_along(positions_, grid.toward);
  grid.corner = x.low * grid.right + y.low * grid.up + z.high * grid.toward;
  grid.depth = z.span();
  grid.pixel = std::max(x.span(), y.span()) / pixels;
  const auto count = [&](const Range& range) {
    return std::clamp(static_cast<std::uint32_t>(std::ceil(range.span() / grid.pixel)), 1U, pixels);
  };
  grid.columns = count(x);
  grid.rows = count(y);
  return grid;
}

std::vector<double> seen_fraction(const FacetMesh& mesh, const std::vector<std::uint32_t>& pixels, double pixel_area,
                                  const Vec3& to_viewer) {
  std::vector<double> fraction(mesh.size(), 0.0);
  for (std::size_t f = 0; f < mesh.size(); ++f) {
    const double projected = mesh.areas[f] * mesh.normals[f].dot(to_viewer);
    if (projected > 0.0) fraction[f] = pixels[f] * pixel_area / projected;
  }
  return fraction;
}

}  // namespace lrcs
