#include "mesh/facet_crosses.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

#include "mesh/facet_mesh.h"

namespace lrcs {
namespace {

// Three corners of each facet, of every size and thinness.
std::vector<Vec3> any_corners(std::size_t facets, double scale, double thinness) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto any = [&] { return Vec3(unit(random), unit(random), unit(random)); };
  std::vector<Vec3> corners;
  for (std::size_t k = 0; k < facets; ++k) {
    const Vec3 a = any(), along = any();
    for (const Vec3& p : {a, Vec3(a + along), Vec3(a + unit(random) * along + thinness * any())})
      corners.emplace_back(scale * p);
    // Some are in a coordinate plane, some have no area, some are flat but for their last digit.
    if (k % 5 == 0) corners.back().x() = corners[3 * k].x() = corners[3 * k + 1].x();
    if (k % 7 == 0) corners.back() = corners[3 * k];
  }
  return corners;
}

bool same_bits(const Vec3& a, const Vec3& b) {
  for (Eigen::Index k = 0; k < 3; ++k)
    if (std::bit_cast<std::uint64_t>(a[k]) != std::bit_cast<std::uint64_t>(b[k])) return false;
  return true;
}

TEST(FacetCrosses, AreThoseOfOneFacetAtATimeToTheBit) {
  constexpr std::size_t facets = 1000;
  for (const double scale : {1.0, 1e-90, 1e-140, 1e99}) {
    for (const double thinness : {1.0, 1e-8, 1e-13, 1e-16, 0.0}) {
      const std::vector<Vec3> corners = any_corners(facets, scale, thinness);
      std::vector<std::array<std::uint32_t, 3>> list;
      for (std::uint32_t k = 0; k < facets; ++k) list.push_back({3 * k, 3 * k + 1, 3 * k + 2});
      std::vector<Vec3> crosses(facets);
      facet_crosses(corners, list, crosses);
      for (std::size_t k = 0; k < facets; ++k)
        ASSERT_TRUE(same_bits(crosses[k], facet_cross(corners[3 * k], corners[3 * k + 1], corners[3 * k + 2])))
            << "facet " << k << ", scale " << scale << ", thinness " << thinness;
    }
  }
}

TEST(MeasureFacets, TakesTheLengthThatEigenTakes) {
  FacetMesh mesh;
  mesh.positions = any_corners(1000, 1.0, 1e-3);
  for (std::uint32_t k = 0; k < 1000; ++k) mesh.facets.push_back({3 * k, 3 * k + 1, 3 * k + 2});
  measure_facets(mesh);
  for (std::size_t k = 0; k < mesh.size(); ++k) {
    const auto [a, b, c] = mesh.corners(k);
    EXPECT_EQ(mesh.areas[k], 0.5 * facet_cross(a, b, c).stableNorm());
  }
}

}  // namespace
}  // namespace lrcs
