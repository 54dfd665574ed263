#include "mesh/facet_mesh.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "made_meshes.h"

namespace lrcs {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Triple = std::array<Vec3, 3>;

std::array<Rational, 3> exact_cross(const Triple& t) {
  std::array<Rational, 3> p;
  std::array<Rational, 3> q;
  for (int k = 0; k < 3; ++k) {
    p[static_cast<std::size_t>(k)] = Rational(t[1][k]) - Rational(t[0][k]);
    q[static_cast<std::size_t>(k)] = Rational(t[2][k]) - Rational(t[0][k]);
  }
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

// The largest error of a component, in units in its last place.
double error_in_ulps(const Triple& t) {
  const Vec3 cross = facet_cross(t[0], t[1], t[2]);
  const auto exact = exact_cross(t);
  double worst = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double value = cross[static_cast<Eigen::Index>(k)];
    const double ulp = std::nextafter(std::abs(value), std::numeric_limits<double>::infinity()) - std::abs(value);
    const Rational error = Rational(value) - exact[k];
    worst = std::max(worst, std::abs(static_cast<double>(error / Rational(ulp))));
  }
  return worst;
}

// A triangle of edges near 1, anywhere within 1000 of the origin, whose third corner is `height` off the first edge's
// line.
Triple needle(std::mt19937_64& random, double height) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto any = [&] { return Vec3(unit(random), unit(random), unit(random)); };
  const Vec3 a = 1000.0 * any();
  const Vec3 along = any();
  return {a, a + along, a + unit(random) * along + height * any()};
}

TEST(FacetCross, IsExactToTwoUnitsInTheLastPlaceHoweverThinTheFacet) {
  std::mt19937_64 random(1);
  for (const double height : {1.0, 1e-3, 1e-6, 1e-10, 1e-13, 1e-16}) {
    for (int k = 0; k < 500; ++k) EXPECT_LE(error_in_ulps(needle(random, height)), 2.0) << "height " << height;
  }
}

TEST(FacetCross, IsExactlyZeroWhereTheCornersAreExactlyCollinear) {
  std::mt19937_64 random(2);
  std::uniform_int_distribution<int> steps(-1000, 1000);
  for (int k = 0; k < 500; ++k) {
    const Vec3 along = Vec3(steps(random), steps(random), steps(random)) / 1024.0;
    const Vec3 a = Vec3(steps(random), steps(random), steps(random)) / 256.0;
    EXPECT_TRUE(facet_cross(a, a + steps(random) * along, a + steps(random) * along).isZero(0.0));
  }
}

TEST(FacetCross, IsNotZeroWhereACornerIsOneUnitInTheLastPlaceOffTheLine) {
  const Vec3 cross = facet_cross({0, 0, 0}, {1, 1, 0}, {0.5, std::nextafter(0.5, 1.0), 0});
  EXPECT_EQ(cross, Vec3(0, 0, std::nextafter(0.5, 1.0) - 0.5));
}

TEST(FacetCross, TurnsRoundWhereTwoCornersAreSwapped) {
  std::mt19937_64 random(3);
  for (int k = 0; k < 200; ++k) {
    const auto [a, b, c] = needle(random, 1e-10);
    EXPECT_EQ(facet_cross(a, c, b), -facet_cross(a, b, c));
  }
}

TEST(MeasureFacets, GivesTheAreaOfANeedleOfAspectTenToTheTen) {
  std::mt19937_64 random(4);
  for (int k = 0; k < 200; ++k) {
    const auto [a, b, c] = needle(random, 1e-10);
    const FacetMesh mesh = mesh_of({a, b, c}, {{0, 1, 2}});
    const auto exact = exact_cross({a, b, c});
    const Rational square = (exact[0] * exact[0] + exact[1] * exact[1] + exact[2] * exact[2]) / 4;
    const double ratio = static_cast<double>(Rational(mesh.areas[0]) * Rational(mesh.areas[0]) / square);
    EXPECT_NEAR(ratio, 1.0, 8.0 * std::numeric_limits<double>::epsilon());
    EXPECT_NEAR(mesh.normals[0].norm(), 1.0, 4.0 * std::numeric_limits<double>::epsilon());
  }
}

TEST(MeasureFacets, GivesNoNormalToAFacetOfNoArea) {
  const FacetMesh mesh = mesh_of({{0, 0, 0}, {0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}}, {{0, 1, 2}, {0, 0, 1}});
  EXPECT_EQ(mesh.areas, (std::vector<double>{0.0, 0.0}));
  EXPECT_EQ(mesh.normals[0], Vec3::Zero());
  EXPECT_EQ(mesh.normals[1], Vec3::Zero());
}

TEST(MeasureFacets, PointsTheNormalsOfABoxOutward) {
  const FacetMesh mesh = unit_box();
  for (std::size_t k = 0; k < mesh.size(); ++k) {
    const auto [a, b, c] = mesh.corners(k);
    EXPECT_GT(mesh.normals[k].dot((a + b + c) / 3.0 - Vec3(0.5, 0.5, 0.5)), 0.0);
    EXPECT_EQ(mesh.areas[k], 0.5);
  }
}

}  // namespace
}  // namespace lrcs
