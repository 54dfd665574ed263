#include "mesh/exact_height.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lrcs {
namespace {

TEST(ExactHeight, IsSixTimesTheTetrahedron) {
  EXPECT_EQ(exact_height({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.2, 5}), 5.0);
  EXPECT_EQ(exact_height({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0.3, 0.2, 5}), -5.0);
}

TEST(ExactHeight, IsZeroOnlyInThePlane) {
  // On the plane x + y + z = 3 * 2^40, off it by the last bit: double precision sees neither.
  const double h = 0x1p40;
  const Vec3 a(h, h, h), b(h + 1, h - 1, h), c(h, h + 1, h - 1);
  EXPECT_EQ(exact_height(a, b, c, Vec3(h + 7, h - 3, h - 4)), 0.0);
  EXPECT_GT(exact_height(a, b, c, Vec3(h + 7, h - 3, std::nextafter(h - 4, 2 * h))), 0.0);
  EXPECT_LT(exact_height(a, b, c, Vec3(h + 7, h - 3, std::nextafter(h - 4, 0.0))), 0.0);
}

}  // namespace
}  // namespace lrcs
