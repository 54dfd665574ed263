#include "mesh/collinear.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mesh/facet_mesh.h"

namespace lrcs {
namespace {

// Law: the same as the exact cross product being zero, also a last place away from a line, and far from the origin.
TEST(Collinear, IsWhereTheCrossProductIsExactlyZero) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> whole(-4, 4);
  const auto place = [&](double origin) { return Vec3(origin + whole(random), whole(random), 0.25 * whole(random)); };
  int collinear = 0;
  for (const double origin : {0.0, 1e6, 1e15})
    for (int k = 0; k < 20000; ++k) {
      const Vec3 a = place(origin), b = place(origin);
      Vec3 c = a + whole(random) * (b - a);
      if (k % 3 == 1) c = place(origin);
      if (k % 3 == 2) c.y() = std::nextafter(c.y(), 9.0);
      EXPECT_EQ(are_collinear(a, b, c), facet_cross(a, b, c).isZero(0.0));
      collinear += are_collinear(a, b, c) ? 1 : 0;
    }
  EXPECT_GT(collinear, 10000);
  EXPECT_LT(collinear, 50000);
}

}  // namespace
}  // namespace lrcs
