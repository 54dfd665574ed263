#include "fit/thinned.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace lrcs {
namespace {

// Scans of 50 samples, of which every 25th is bright; each line is unique.
std::vector<BrdfSample> scans(int count) {
  std::vector<BrdfSample> samples;
  for (int k = 0; k < count; ++k) {
    BrdfSample s;
    s.theta_r = 0.02 * (k % 50);
    s.f_r = k % 25 == 7 ? 100.0 : 1.0;
    s.line = k + 1;
    samples.push_back(s);
  }
  return samples;
}

TEST(Thinned, IsAllWhereTheyAreFew) {
  EXPECT_EQ(thinned(scans(100), 100, 1).size(), 100U);
}

TEST(Thinned, HasSamplesOnceAndStandsForAll) {
  const auto few = thinned(scans(10000), 500, 1);
  ASSERT_EQ(few.size(), 500U);
  std::set<int> lines;
  double weight = 0.0;
  for (const BrdfSample& s : few) {
    lines.insert(s.line);
    weight += s.weight;
  }
  EXPECT_EQ(lines.size(), 500U);
  EXPECT_DOUBLE_EQ(weight, 10000.0);
}

TEST(Thinned, HasAllOfASmallShareThatIsBright) {
  int bright = 0;
  for (const BrdfSample& s : thinned(scans(2000), 500, 1)) bright += s.f_r == 100.0 ? 1 : 0;
  EXPECT_EQ(bright, 80);
}

// Stretches of 50 samples, as long as a scan: a sample every so many would have one angle only.
TEST(Thinned, DoesNotSeeTheScansPeriod) {
  std::set<double> angles;
  for (const BrdfSample& s : thinned(scans(20000), 500, 1)) angles.insert(s.theta_r);
  EXPECT_EQ(angles.size(), 50U);
}

TEST(Thinned, IsTheSameForASeed) {
  const auto lines = [](std::uint64_t seed) {
    std::vector<int> all;
    for (const BrdfSample& s : thinned(scans(10000), 500, seed)) all.push_back(s.line);
    return all;
  };
  EXPECT_EQ(lines(3), lines(3));
  EXPECT_NE(lines(3), lines(4));
}

}  // namespace
}  // namespace lrcs
