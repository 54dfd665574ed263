#include "base/direction.h"

#include <gtest/gtest.h>

namespace lrcs {
namespace {

TEST(Direction, IsExactAlongTheAxes) {
  EXPECT_EQ(direction_of({0, 0}), Vec3(1, 0, 0));
  EXPECT_EQ(direction_of({90, 0}), Vec3(0, 1, 0));
  EXPECT_EQ(direction_of({180, 0}), Vec3(-1, 0, 0));
  EXPECT_EQ(direction_of({-90, 0}), Vec3(0, -1, 0));
  EXPECT_EQ(direction_of({270, 0}), Vec3(0, -1, 0));
  EXPECT_EQ(direction_of({360, 0}), direction_of({0, 0}));
  EXPECT_EQ(direction_of({0, 90}), Vec3(0, 0, 1));
  EXPECT_EQ(direction_of({0, -90}), Vec3(0, 0, -1));
}

TEST(Direction, FollowsTheFormulaEverywhere) {
  for (double azimuth = -360.0; azimuth <= 360.0; azimuth += 7.3)
    for (double elevation = -90.0; elevation <= 90.0; elevation += 6.1) {
      const double a = azimuth * degree, e = elevation * degree;
      const Vec3 formula(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e));
      EXPECT_LT((direction_of({azimuth, elevation}) - formula).norm(), 2e-15);
      EXPECT_NEAR(direction_of({azimuth, elevation}).norm(), 1.0, 4e-16);
    }
}

TEST(Direction, ComesBackAsAngles) {
  for (double azimuth = 0.0; azimuth < 360.0; azimuth += 11.7)
    for (double elevation = -85.0; elevation <= 85.0; elevation += 8.5) {
      const AspectAngles angles = angles_of(direction_of({azimuth, elevation}));
      EXPECT_NEAR(angles.azimuth_deg, azimuth, 1e-12);
      EXPECT_NEAR(angles.elevation_deg, elevation, 1e-12);
    }
  EXPECT_EQ(angles_of(Vec3(0, 0, 1)), (AspectAngles{0.0, 90.0}));
}

TEST(Direction, GrowsAlongTheUnitVectorsOfItsAngles) {
  const double step = 1e-6;
  for (const AspectAngles at : {AspectAngles{33, 20}, AspectAngles{200, -70}}) {
    const Vec3 by_azimuth = direction_of({at.azimuth_deg + step, at.elevation_deg}) - direction_of(at);
    const Vec3 by_elevation = direction_of({at.azimuth_deg, at.elevation_deg + step}) - direction_of(at);
    EXPECT_LT((by_azimuth.normalized() - along_azimuth(at)).norm(), 1e-7);
    EXPECT_LT((by_elevation.normalized() - along_elevation(at)).norm(), 1e-7);
  }
}

}  // namespace
}  // namespace lrcs
