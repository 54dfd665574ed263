#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "lrcs/visibility.h"
#include "tests/lrcs/exact_clipping.h"
#include "tests/lrcs/test_targets.h"

namespace lrcs {
namespace {

double between(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

// A direction from which one of the facets is seen at the given cosine.
Vec3 grazing(const FacetMesh& mesh, double cosine, std::mt19937_64& random) {
  const Vec3& n = mesh.normals[random() % mesh.size()];
  const Vec3 aside = random_direction(random);
  const Vec3 along = (aside - aside.dot(n) * n).normalized();
  return (along * std::sqrt(1.0 - cosine * cosine) + cosine * n).normalized();
}

// Walk and clipping each within their own bound of what rational arithmetic finds.
void expect_true(const FacetMesh& mesh, const std::vector<Vec3>& viewers) {
  const Visibility visibility(mesh);
  const auto walked = visibility.seen_fraction(viewers.front(), viewers.back());
  const auto clipped = visibility.seen_fraction_by_clipping(viewers.front(), viewers.back());
  const ExactClipping exact(mesh);
  for (std::size_t f = 0; f < mesh.size(); ++f) {
    const double truth = exact.seen_fraction(f, viewers).value_or(0.0);
    constexpr double rounding_of_truth = 1e-15;
    EXPECT_NEAR(walked[f].value, truth, walked[f].bound + rounding_of_truth) << "facet " << f;
    EXPECT_NEAR(clipped[f].value, truth, clipped[f].bound + rounding_of_truth) << "facet " << f;
  }
}

// Five facets about a tip, turned at random.
FacetMesh fan(std::mt19937_64& random) {
  FacetMesh mesh;
  const std::uint32_t tip = add_vertex(mesh, {0, 0, 1});
  for (int k = 0; k < 5; ++k) add_vertex(mesh, {std::cos(0.4 * M_PI * k), std::sin(0.4 * M_PI * k), 0.4});
  for (std::uint32_t k = 0; k < 5; ++k) add_facet(mesh, tip + 1 + k, tip + 1 + (k + 1) % 5, tip);
  const Eigen::AngleAxisd turn(between(random, 0.0, 6.0), random_direction(random));
  for (Vec3& p : mesh.positions) p = turn * p;
  return mesh;
}

// Copies that differ by next to nothing cross each other in places that a grazing view hardly tells from the rims of
// their facets.
TEST(GrazingContacts, OfNearlyCoincidentFansAreCountedRight) {
  for (unsigned seed = 1; seed <= 120; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    const FacetMesh one = fan(random);
    FacetMesh mesh = one, other = one;
    const double apart = std::pow(10.0, between(random, -15.7, -4.0));
    const Eigen::AngleAxisd turn(apart, random_direction(random));
    for (Vec3& p : other.positions) {
      const Vec3 shift(between(random, -1.0, 1.0), between(random, -1.0, 1.0), between(random, -1.0, 1.0));
      p = seed % 2 == 0 ? Vec3(turn * p) : Vec3(p + apart * shift);
    }
    append(mesh, other);
    measure_facets(mesh);
    const Vec3 d = grazing(mesh, std::pow(10.0, between(random, -9.0, -1.0)), random);
    if (seed % 4 < 2)
      expect_true(mesh, {d});
    else
      expect_true(mesh, {d, (d + 0.3 * random_direction(random)).normalized()});
  }
}

// Spheres of ten sectors and copies of them, turned by next to nothing: views along a meridian see facets all but
// edge-on.
TEST(GrazingContacts, OfNearlyCoincidentSpheresGiveTheSigmaOfClipping) {
  const double step = M_PI / 10.0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937_64 random(seed);
    FacetMesh mesh = sphere(1.0, 5), copy = mesh;
    const Eigen::AngleAxisd turn(std::pow(10.0, between(random, -10.0, -8.0)), random_direction(random));
    for (Vec3& p : copy.positions) p = turn * p;
    append(mesh, copy);
    const Target target = target_of(mesh, library("metal-skin-5p"));
    const Visibility visibility(target.mesh);
    for (int k = 0; k < 20; ++k) {
      const Vec3 d(std::cos(step * k), std::sin(step * k), 0.0);
      const Estimate walked = cross_section(target, visibility, d, d).sigma;
      const Estimate clipped = cross_section(target, visibility.seen_fraction_by_clipping(d, d), d, d).sigma;
      EXPECT_NEAR(walked.value, clipped.value, walked.bound + clipped.bound) << "seed " << seed << ", meridian " << k;
    }
  }
}

// What is left out for it overlaps by less than rounding counts in the bound with its own reach, however far.
TEST(GrazingContacts, OfAnOpenNeedleBoxKeepTheirBounds) {
  for (unsigned seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    FacetMesh mesh;
    add_box(mesh, {0, 0, 0}, {1e-4, 1, 1e-4});
    mesh.facets.erase(mesh.facets.begin());
    const Eigen::AngleAxisd turn(1.0 + seed, Vec3(1, 2, 3).normalized());
    for (Vec3& p : mesh.positions) p = turn * p;
    measure_facets(mesh);
    expect_true(mesh, {grazing(mesh, std::pow(10.0, between(random, -13.0, -8.0)), random)});
  }
}

}  // namespace
}  // namespace lrcs
