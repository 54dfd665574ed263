#include "mesh/curved_patch.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lrcs {
namespace {

using Place = std::array<double, 3>;

double factorial(int n) {
  return n <= 1 ? 1.0 : n * factorial(n - 1);
}

// The mean of a^i b^j c^k over a triangle.
double mean_of(int i, int j, int k) {
  return 2.0 * factorial(i) * factorial(j) * factorial(k) / factorial(i + j + k + 2);
}

TEST(CurvedPatch, RulesAreExactToTheirDegrees) {
  for (int i = 0; i <= 5; ++i)
    for (int j = 0; i + j <= 5; ++j) {
      const int k = 5 - i - j;
      double sum = 0.0, lower = 0.0;
      for (std::size_t p = 0; p < PatchRule::size; ++p) {
        const auto& [a, b, c] = patch_rule().at[p];
        sum += patch_rule().weight[p] * std::pow(a, i) * std::pow(b, j) * std::pow(c, k);
        if (i + j <= 2) lower += patch_rule().lower[p] * std::pow(a, i) * std::pow(b, j);
      }
      EXPECT_NEAR(sum, mean_of(i, j, k), 1e-15) << i << j << k;
      if (i + j > 2) continue;
      EXPECT_NEAR(lower, mean_of(i, j, 0), 1e-15) << i << j;
    }
}

// With area vectors of second degree.
CurvedPatch bowl() {
  CurvedPatch patch;
  for (std::size_t k = 0; k < PatchRule::size; ++k) {
    const auto& [a, b, c] = patch_rule().at[k];
    const Vec3 vector(0.2 * a * b, 0.3 * c - 0.1 * a * a, 1.0 + 0.2 * b);
    patch.area[k] = vector.norm();
    patch.normal[k] = vector / patch.area[k];
  }
  return patch;
}

Vec3 total(const CurvedPatch& patch) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < PatchRule::size; ++k) sum += patch_rule().weight[k] * patch.area[k] * patch.normal[k];
  return sum;
}

TEST(CurvedPatch, AreaVectorsOfSecondDegreeAreKnownEverywhere) {
  const Place at{0.7, 0.25, 0.05};
  const Vec3 exact(0.2 * at[0] * at[1], 0.3 * at[2] - 0.1 * at[0] * at[0], 1.0 + 0.2 * at[1]);
  EXPECT_LT((PatchPolynomial(bowl()).at(at) - exact).norm(), 1e-14);
  EXPECT_LT((PatchPolynomial(bowl()).at({1.0, 0.0, 0.0}) - Vec3(0.0, -0.1, 1.0)).norm(), 1e-14);
}

TEST(CurvedPatch, PartsAddUpToTheWhole) {
  const Place a{1, 0, 0}, b{0, 1, 0}, c{0, 0, 1}, middle{0.5, 0.2, 0.3};
  const Vec3 sum = total(PatchPolynomial(bowl()).part({a, b, middle})) +
                   total(PatchPolynomial(bowl()).part({b, c, middle})) +
                   total(PatchPolynomial(bowl()).part({c, a, middle}));
  EXPECT_LT((sum - total(bowl())).norm(), 1e-14);
  EXPECT_LT((total(PatchPolynomial(bowl()).part({a, middle, b})) + total(PatchPolynomial(bowl()).part({a, b, middle})))
                .norm(),
            1e-14);
}

TEST(CurvedPatch, TurnedOverItLooksTheOtherWayAndCornersChangePlaces) {
  CurvedPatch patch = bowl();
  turn_over(patch);
  EXPECT_LT((PatchPolynomial(patch).at({0.2, 0.3, 0.5}) + PatchPolynomial(bowl()).at({0.2, 0.5, 0.3})).norm(), 1e-14);
  turn_over(patch);
  EXPECT_EQ(patch.area, bowl().area);
}

}  // namespace
}  // namespace lrcs
