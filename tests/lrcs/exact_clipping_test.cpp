// The seen fraction of every facet, and its bound, against rational arithmetic on seeded dirty targets.
#include "tests/lrcs/exact_clipping.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "lrcs/visibility.h"
#include "tests/lrcs/test_targets.h"

namespace lrcs {
namespace {

class Dirt {
 public:
  explicit Dirt(unsigned seed) : random_(seed) {
    Eigen::Quaterniond q(real(-1, 1), real(-1, 1), real(-1, 1), real(-1, 1));
    turn_ = q.normalized().toRotationMatrix();
  }
  double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  double whole(int most) { return std::uniform_int_distribution<int>(0, most)(random_); }
  double decade(double low, double high) { return std::pow(10.0, real(low, high)); }
  Vec3 vec() { return {real(-1, 1), real(-1, 1), real(-1, 1)}; }
  Vec3 turned(const Vec3& p) const { return turn_ * p; }
  Vec3 direction() { return random_direction(random_); }

 private:
  std::mt19937_64 random_;
  Eigen::Matrix3d turn_;
};

void expect_within_bounds(FacetMesh mesh, const Vec3& di, const Vec3& dr) {
  measure_facets(mesh);
  const auto seen = Visibility(mesh).seen_fraction(di, dr);
  const ExactClipping exact(mesh);
  const std::vector<Vec3> viewers = di == dr ? std::vector{di} : std::vector{di, dr};
  for (std::size_t k = 0; k < mesh.size(); ++k) {
    if (mesh.areas[k] == 0.0) continue;
    const auto truth = exact.seen_fraction(k, viewers);
    if (!truth) continue;
    EXPECT_LE(std::abs(seen[k].value - *truth), seen[k].bound) << "facet " << k;
  }
}

template <class Make>
void expect_within_bounds_on(unsigned seeds, const Make& make) {
  for (unsigned seed = 0; seed < seeds; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Dirt dirt(seed);
    const Vec3 di = dirt.direction(), other = dirt.direction();
    expect_within_bounds(make(dirt, di), di, seed % 2 == 0 ? di : other);
  }
}

TEST(ExactSeenFraction, OfFacetsOnAGridFullOfCoincidences) {
  expect_within_bounds_on(30, [](Dirt& dirt, const Vec3&) {
    FacetMesh mesh;
    const auto p = [&] { return Vec3(dirt.whole(3), dirt.whole(3), dirt.whole(3)); };
    for (int k = 0; k < 9; ++k) add_triangle(mesh, p(), p(), p());
    return mesh;
  });
}

TEST(ExactSeenFraction, OfCoplanarFacetsTurnedAnyWay) {
  expect_within_bounds_on(30, [](Dirt& dirt, const Vec3&) {
    FacetMesh mesh;
    const auto p = [&] { return dirt.turned(Vec3(dirt.whole(4) / 3, dirt.whole(4) / 3, dirt.whole(1) / 3)); };
    for (int k = 0; k < 8; ++k) add_triangle(mesh, p(), p(), p());
    return mesh;
  });
}

TEST(ExactSeenFraction, OfFacetsThatCrossAtAnyTinyAngle) {
  expect_within_bounds_on(60, [](Dirt& dirt, const Vec3&) {
    FacetMesh mesh;
    const double tilt = dirt.decade(-16, -4);
    const auto p = [&] { return dirt.turned(Vec3(dirt.real(-1, 1), dirt.real(-1, 1), tilt * dirt.real(-1, 1))); };
    for (int k = 0; k < 6; ++k) add_triangle(mesh, p(), p(), p());
    return mesh;
  });
}

TEST(ExactSeenFraction, OfNeedles) {
  expect_within_bounds_on(30, [](Dirt& dirt, const Vec3&) {
    FacetMesh mesh;
    for (int k = 0; k < 8; ++k) {
      const Vec3 p = dirt.vec(), q = p + dirt.vec(), aside = dirt.decade(-15, -1) * dirt.vec();
      add_triangle(mesh, p, q, p + dirt.real(0, 1) * (q - p) + aside);
    }
    for (int k = 0; k < 3; ++k) add_triangle(mesh, dirt.vec(), dirt.vec(), dirt.vec());
    return mesh;
  });
}

TEST(ExactSeenFraction, OfFacetsNearlyEdgeOn) {
  expect_within_bounds_on(30, [](Dirt& dirt, const Vec3& di) {
    FacetMesh mesh;
    for (int k = 0; k < 8; ++k) {
      const Vec3 p = dirt.vec();
      add_triangle(mesh, p, p + dirt.decade(-1, 0) * di + dirt.decade(-17, -6) * dirt.vec(), p + dirt.vec());
    }
    return mesh;
  });
}

TEST(ExactSeenFraction, OfFacetsFarFromTheOrigin) {
  expect_within_bounds_on(20, [](Dirt& dirt, const Vec3&) {
    FacetMesh mesh;
    const Vec3 far = 1e6 * dirt.vec();
    for (int k = 0; k < 9; ++k) {
      const Vec3 p = far + dirt.vec();
      add_triangle(mesh, p, p + dirt.vec(), p + dirt.vec());
    }
    return mesh;
  });
}

}  // namespace
}  // namespace lrcs
