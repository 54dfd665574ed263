#include "fit/gsaa.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lrcs {
namespace {

// Rastrigin's function over [-5.12, 5.12]^3, its least value 0 at 0.9 in each: 11^3 minima, the next best at 1.
double rastrigin(std::span<const double> place) {
  double sum = 0.0;
  for (const double c : place) {
    const double x = 10.24 * c - 5.12 - 0.9;
    sum += x * x + 10.0 * (1.0 - std::cos(2.0 * std::numbers::pi * x));
  }
  return sum;
}

TEST(Gsaa, FindsTheDeepestOfAThousandMinima) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    GsaaOptions options;
    options.population = 100;
    options.generations = 60;
    options.seed = seed;
    if (gsaa(3, options, rastrigin).front().error < 0.5) ++found;
  }
  EXPECT_GE(found, 15);
}

TEST(Gsaa, CallsTheErrorSoOftenAsItSaysWithinTheUnitCube) {
  for (const int generations : {0, 1, 7}) {
    GsaaOptions options;
    options.population = 9;
    options.generations = generations;
    options.step = 5.0;  // far beyond the cube
    int calls = 0;
    const auto error = [&](std::span<const double> place) {
      ++calls;
      EXPECT_EQ(place.size(), 4U);
      EXPECT_GE(*std::min_element(place.begin(), place.end()), 0.0);
      EXPECT_LE(*std::max_element(place.begin(), place.end()), 1.0);
      return rastrigin(place);
    };
    EXPECT_GE(gsaa(4, options, error).size(), 9U);
    EXPECT_EQ(calls, 9 * (generations + 1));
  }
}

TEST(Gsaa, GivesTheBestEverFirstAndTheOthersInOrder) {
  GsaaOptions options;
  options.temperature = 1e3;  // nearly everything is accepted: the best is lost from the population
  options.cooling = 1.0;
  double best = 1e300;
  const auto candidates = gsaa(3, options, [&](std::span<const double> place) {
    best = std::min(best, rastrigin(place));
    return rastrigin(place);
  });
  EXPECT_EQ(candidates.front().error, best);
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    EXPECT_EQ(candidates[k].error, rastrigin(candidates[k].place));
    if (k > 0) {
      EXPECT_LE(candidates[k - 1].error, candidates[k].error);
    }
  }
}

TEST(Gsaa, IsTheSameForTheSameSeedOnly) {
  GsaaOptions options;
  const auto first = gsaa(3, options, rastrigin);
  const auto again = gsaa(3, options, rastrigin);
  options.seed = 2;
  const auto other = gsaa(3, options, rastrigin);
  ASSERT_EQ(first.size(), again.size());
  for (std::size_t k = 0; k < first.size(); ++k) EXPECT_EQ(first[k].place, again[k].place);
  EXPECT_NE(first.front().place, other.front().place);
}

}  // namespace
}  // namespace lrcs
