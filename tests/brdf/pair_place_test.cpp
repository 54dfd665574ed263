#include "brdf/pair_place.h"

#include <gtest/gtest.h>

#include "measurement/half_difference.h"
#include "tests/brdf/sample_brdfs.h"

namespace lrcs {
namespace {

Vec3 place(double theta_h, double theta_d, double phi_d) {
  const auto [wi, wr] = directions_of_half_difference(theta_h, theta_d, phi_d);
  return pair_place(wi, wr, Vec3::UnitZ());
}

TEST(PairPlace, IsTheOneOfItsHalfAndDifferenceAngles) {
  RandomDirections random(51);
  for (int k = 0; k < 1000; ++k) {
    const double h = random.uniform(0.0, 0.7), d = random.uniform(0.0, 0.7), phi = random.uniform(-7.0, 7.0);
    EXPECT_LT((place(h, d, phi) - pair_place(h, d, std::cos(phi), std::sin(phi))).norm(), 1e-14);
  }
}

TEST(PairPlace, PutsSpecularAndRetroPairsOnTheTwoHalvesOfAnAxis) {
  for (const double phi : {0.0, 0.4, 1.5, 3.0}) {
    EXPECT_LT((place(0.0, 0.6, phi) - Vec3(-0.6, 0.0, 0.0)).norm(), 1e-15);
    EXPECT_LT((place(0.6, 0.0, phi) - Vec3(0.6, 0.0, 0.0)).norm(), 1e-15);
  }
  EXPECT_EQ(pair_place(Vec3::UnitZ(), Vec3::UnitZ(), Vec3::UnitZ()), Vec3(0.0, 0.0, 0.0));
  EXPECT_NEAR(pair_place_retro(std::cos(0.6)).x(), 0.6, 1e-15);
}

TEST(PairPlace, IsContinuousWherePhiMeansNothing) {
  for (const double small : {1e-3, 1e-6, 1e-9})
    for (const double phi : {0.0, 0.4, 1.5, 3.0}) {
      EXPECT_LT((place(small, 0.6, phi) - place(0.0, 0.6, 0.0)).norm(), 2.1 * pair_stretch * small);
      EXPECT_LT((place(0.6, small, phi) - place(0.6, 0.0, 0.0)).norm(), 2.1 * pair_stretch * small);
    }
}

// No two pairs that differ fall together: the inverse is as continuous.
TEST(PairPlace, KeepsPairsApartThatAreApart) {
  RandomDirections random(52);
  for (int k = 0; k < 1000; ++k) {
    const double h = random.uniform(0.01, 0.7), d = random.uniform(0.01, 0.7), phi = random.uniform(0.01, 1.5);
    const double step = 1e-5;
    const Vec3 here = place(h, d, phi);
    Eigen::Matrix3d slopes;  // by h, d, and the arcs that phi makes of the shorter one
    slopes.col(0) = (place(h + step, d, phi) - here) / step;
    slopes.col(1) = (place(h, d + step, phi) - here) / step;
    slopes.col(2) = (place(h, d, phi + step) - here) / (step * std::min(h, d));
    const Eigen::Vector3d stretch = slopes.jacobiSvd().singularValues();
    EXPECT_LT(stretch[0], 2.01 * pair_stretch);
    EXPECT_GT(stretch[2], 0.99);
  }
}

TEST(PairPlace, IsTheSameToTheLastBitExchangedOrInAMirror) {
  RandomDirections random(53);
  const auto mirrored = [](const Vec3& w) { return Vec3(w.x(), -w.y(), w.z()); };
  for (int k = 0; k < 1000; ++k) {
    const Vec3 n = random.on_sphere(), wi = random.above(n, 1.57), wr = random.above(n, 1.57);
    EXPECT_EQ(pair_place(wi, wr, n), pair_place(wr, wi, n));
    EXPECT_EQ(pair_place(wi, wr, n), pair_place(mirrored(wi), mirrored(wr), mirrored(n)));
  }
}

TEST(PairPlace, OfPairsInThePlaneOfIncidenceHasNoThirdCoordinate) {
  for (const double r : {-1.3, -0.5, 0.0, 0.2, 0.5, 1.4})
    EXPECT_LT(pair_place(from_angles(0.5, 0.0), from_angles(r, 0.0), Vec3::UnitZ()).z(), 1e-15);
}

}  // namespace
}  // namespace lrcs
