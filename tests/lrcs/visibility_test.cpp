#include "lrcs/visibility.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <random>

#include "tests/lrcs/test_targets.h"

namespace lrcs {
namespace {

// Area of the facets lit and seen, projected toward the receiver.
double seen_area(FacetMesh mesh, const Vec3& di, const Vec3& dr) {
  measure_facets(mesh);
  const auto seen = Visibility(mesh).seen_fraction(di, dr);
  double area = 0.0;
  for (std::size_t k = 0; k < mesh.size(); ++k)
    area += seen[k].value * mesh.areas[k] * std::abs(mesh.normals[k].dot(dr));
  return area;
}

double seen_area(const FacetMesh& mesh, const Vec3& d) {
  return seen_area(mesh, d, d);
}

const Vec3 above(0, 0, 1);

TEST(Visibility, SeesAPlateFromBothSidesAndNotEdgeOn) {
  FacetMesh mesh;
  add_plate(mesh, {0, 0, 0}, {2, 0, 0}, {0, 3, 0});
  EXPECT_DOUBLE_EQ(seen_area(mesh, above), 6.0);
  EXPECT_DOUBLE_EQ(seen_area(mesh, -above), 6.0);
  EXPECT_EQ(seen_area(mesh, Vec3(1, 0, 0)), 0.0);
  const Vec3 oblique = Vec3(0, std::sin(1.0), std::cos(1.0));
  EXPECT_NEAR(seen_area(mesh, oblique), 6.0 * std::cos(1.0), 1e-14);
}

TEST(Visibility, HalvesAFacetWhereTheShadowHalvesIt) {
  FacetMesh mesh;
  add_plate(mesh, {0, 0, 0}, {2, 0, 0}, {0, 2, 0});
  add_plate(mesh, {1, -1, 1}, {5, 0, 0}, {0, 5, 0});
  measure_facets(mesh);
  const auto seen = Visibility(mesh).seen_fraction(above, above);
  // The diagonal runs from (0, 0) to (2, 2): of one facet a quarter lies left of x = 1, of the other three quarters.
  EXPECT_NEAR(seen[0].value, 0.25, 1e-15);
  EXPECT_NEAR(seen[1].value, 0.75, 1e-15);
  EXPECT_NEAR(seen[2].value, 1.0, 1e-15);
}

TEST(Visibility, OfAConvexBodyIsItsProjection) {
  FacetMesh mesh;
  add_box(mesh, {0, 0, 0}, {1, 2, 3});
  std::mt19937_64 random(3);
  for (int k = 0; k < 50; ++k) {
    const Vec3 d = random_direction(random);
    const double projection = 6 * std::abs(d.x()) + 3 * std::abs(d.y()) + 2 * std::abs(d.z());
    EXPECT_NEAR(seen_area(mesh, d), projection, 1e-14 * projection);
  }
}

TEST(Visibility, DecidesWhereFacetsPassThroughEachOther) {
  // Plates z = 0 and z = x/10: each hides half of the other.
  FacetMesh mesh;
  add_plate(mesh, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
  add_plate(mesh, {-1, -1, -0.1}, {2, 0, 0.2}, {0, 2, 0});
  EXPECT_NEAR(seen_area(mesh, above), 4.0, 1e-14);
  measure_facets(mesh);
  const auto seen = Visibility(mesh).seen_fraction(above, above);
  EXPECT_NEAR(0.5 * (seen[0].value + seen[1].value), 0.5, 1e-14);
  EXPECT_NEAR(0.5 * (seen[2].value + seen[3].value), 0.5, 1e-14);
}

TEST(Visibility, KeepsTheCountOfPlatesThatCrossAtTinyAngles) {
  for (const double tilt : {1e-4, 1e-8, 1e-12, 1e-15, 1e-17}) {
    FacetMesh mesh;
    add_plate(mesh, {-1, -1, 0.25}, {2, 0, 0}, {0, 2, 0});
    add_plate(mesh, {-1, -1, 0.25 - tilt}, {2, 0, 2 * tilt}, {0, 2, 0});
    EXPECT_NEAR(seen_area(mesh, above), 4.0, 1e-13) << "tilt " << tilt;
  }
}

TEST(Visibility, GivesCoincidentFacetsToTheFrontThenToTheLowerIndex) {
  FacetMesh mesh;
  add_plate(mesh, {0, 0, 0}, {0, 1, 0}, {1, 0, 0});  // front is down
  add_plate(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});  // front is up
  add_plate(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  measure_facets(mesh);
  const auto from_above = Visibility(mesh).seen_fraction(above, above);
  const auto from_below = Visibility(mesh).seen_fraction(-above, -above);
  const std::vector<double> up{0, 0, 1, 1, 0, 0}, down{1, 1, 0, 0, 0, 0};
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_EQ(from_above[k].value, up[k]) << k;
    EXPECT_EQ(from_below[k].value, down[k]) << k;
  }
}

TEST(Visibility, CountsPartlyCoincidentPlatesOnce) {
  std::mt19937_64 random(5);
  std::uniform_int_distribution<int> at(0, 12);
  for (int round = 0; round < 30; ++round) {
    FacetMesh mesh;
    std::vector<std::vector<bool>> covered(16, std::vector<bool>(16, false));
    for (int k = 0; k < 6; ++k) {
      const int x = at(random), y = at(random), w = 1 + at(random) / 4, h = 1 + at(random) / 4;
      const bool up = at(random) % 2 == 0;
      const Vec3 u(w, 0, 0), v(0, h, 0);
      add_plate(mesh, Vec3(x, y, 0), up ? u : v, up ? v : u);
      for (int i = x; i < x + w; ++i)
        for (int j = y; j < y + h; ++j) covered[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = true;
    }
    double area = 0.0;
    for (const auto& column : covered) area += static_cast<double>(std::count(column.begin(), column.end(), true));
    EXPECT_NEAR(seen_area(mesh, above), area, 1e-13 * area);
  }
}

TEST(Visibility, OfAStackOfLayersIsTheTopOne) {
  FacetMesh mesh;
  for (int k = 0; k < 1000; ++k) add_plate(mesh, {0, 0, 0.001 * k}, {1, 0, 0}, {0, 1, 0});
  EXPECT_NEAR(seen_area(mesh, above), 1.0, 1e-14);
  EXPECT_NEAR(seen_area(mesh, -above), 1.0, 1e-14);
}

TEST(Visibility, NeedsLightAndSightInOnePlaceForBistatic) {
  // A plate under a roof that shades x < 1 from the transmitter and hides x > 2 from the receiver.
  FacetMesh mesh;
  add_plate(mesh, {0, 0, 0}, {3, 0, 0}, {0, 1, 0});
  add_plate(mesh, {1, -5, 1}, {1, 0, 0}, {0, 10, 0});
  const Vec3 from_left = Vec3(-1, 0, 1).normalized();  // the roof's shadow: 2 < x < 3
  const Vec3 from_right = Vec3(1, 0, 1).normalized();  // hidden: 0 < x < 1
  measure_facets(mesh);
  const auto seen = Visibility(mesh).seen_fraction(from_left, from_right);
  EXPECT_NEAR(1.5 * (seen[0].value + seen[1].value), 1.0, 1e-14);
  EXPECT_NEAR(seen[2].value, 1.0, 1e-15);
}

TEST(Visibility, SeesNothingOfAFacetLitFromBehind) {
  FacetMesh mesh;
  add_plate(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_EQ(seen_area(mesh, above, -above), 0.0);
}

// An independent route: rays from points of the facets toward the viewers, against every other facet.
double seen_by_rays(const FacetMesh& mesh, const Vec3& di, const Vec3& dr, int rays, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto free = [&](const Vec3& x, const Vec3& d, std::size_t own) {
    for (std::size_t k = 0; k < mesh.size(); ++k) {
      if (k == own) continue;
      const auto [a, b, c] = mesh.corners(k);
      Eigen::Matrix3d m;
      m << b - a, c - a, -d;
      const Vec3 s = m.inverse() * (x - a);
      if (s.x() >= 0 && s.y() >= 0 && s.x() + s.y() <= 1 && s.z() > 1e-12) return false;
    }
    return true;
  };
  double area = 0.0;
  for (std::size_t k = 0; k < mesh.size(); ++k) {
    if ((mesh.normals[k].dot(di) > 0) != (mesh.normals[k].dot(dr) > 0)) continue;
    const auto [a, b, c] = mesh.corners(k);
    int seen = 0;
    for (int r = 0; r < rays; ++r) {
      double u = unit(random), v = unit(random);
      if (u + v > 1) u = 1 - u, v = 1 - v;
      const Vec3 x = a + u * (b - a) + v * (c - a);
      seen += free(x, di, k) && free(x, dr, k) ? 1 : 0;
    }
    area += mesh.areas[k] * std::abs(mesh.normals[k].dot(dr)) * seen / rays;
  }
  return area;
}

TEST(Visibility, AgreesWithRaysOnRandomSoups) {
  std::mt19937_64 random(17);
  for (int round = 0; round < 6; ++round) {
    FacetMesh mesh = random_soup(random, 60);
    measure_facets(mesh);
    const Vec3 di = random_direction(random);
    const Vec3 dr = round % 2 == 0 ? di : random_direction(random);
    constexpr int rays = 1500;
    double variance = 0.0;
    for (std::size_t k = 0; k < mesh.size(); ++k)
      variance += std::pow(mesh.areas[k] * std::abs(mesh.normals[k].dot(dr)), 2) * 0.25 / rays;
    // Five standard deviations at least: fails by chance less than once in 10^5 runs.
    EXPECT_NEAR(seen_area(mesh, di, dr), seen_by_rays(mesh, di, dr, rays, random), 5.0 * std::sqrt(variance));
  }
}

TEST(Visibility, HoldsAtScalesAndOffsetsThatDoublesHold) {
  std::mt19937_64 random(23);
  const FacetMesh soup = random_soup(random, 40);
  const Vec3 d = random_direction(random);
  const double area = seen_area(soup, d);
  for (const double scale : {0x1p-300, 0x1p-30, 0x1p30, 0x1p300}) {
    FacetMesh scaled = soup;
    for (Vec3& p : scaled.positions) p *= scale;
    EXPECT_NEAR(seen_area(scaled, d) / scale / scale, area, 1e-14 * area) << scale;
  }
  FacetMesh far = soup;
  for (Vec3& p : far.positions) p = (p.array() * 0x1p20).round() * 0x1p-20 + 0x1p30;
  FacetMesh rounded = far;
  for (Vec3& p : rounded.positions) p.array() -= 0x1p30;
  EXPECT_NEAR(seen_area(far, d), seen_area(rounded, d), 1e-14 * area);
}

TEST(Visibility, GivesTheSameAnswerTwice) {
  std::mt19937_64 random(29);
  FacetMesh mesh = random_soup(random, 200);
  measure_facets(mesh);
  const Visibility visibility(mesh);
  const Vec3 d = random_direction(random);
  const auto once = visibility.seen_fraction(d, d), again = visibility.seen_fraction(d, d);
  for (std::size_t k = 0; k < once.size(); ++k) EXPECT_EQ(once[k].value, again[k].value);
}

TEST(Visibility, EndsInTimeForAFacetUnderAThousandCrossingOnes) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> at(-1.0, 1.0), height(0.1, 1.0);
  FacetMesh mesh;
  add_triangle(mesh, {-1, -1, 0}, {3, -1, 0}, {-1, 3, 0});
  for (int k = 0; k < 1000; ++k) {
    const Vec3 p(at(random), at(random), height(random));
    const auto side = [&] { return Vec3(at(random), at(random), 0.1 * at(random)); };
    add_triangle(mesh, p, p + side(), p + side());
  }
  measure_facets(mesh);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_GT(Visibility(mesh).seen_fraction(above, above)[0].value, 0.0);
  // 1.4 s measured on a slow core; the limit is for a hang.
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
}

}  // namespace
}  // namespace lrcs
