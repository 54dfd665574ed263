#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "lrcs/sampled_sections.h"
#include "tests/lrcs/test_targets.h"

namespace lrcs {

// Sampled sections of a target from twenty seeded directions hold their bounds, which are as small as asked, against
// exact ones.
inline void expect_honest(const Target& target, double relative, bool bistatic, std::uint64_t seed) {
  ASSERT_TRUE(SampledSections::may_pay(target, relative));
  const SampledSections sampled(target, relative, bistatic);
  const Visibility visibility(target.mesh);
  std::mt19937_64 random(seed);
  int found = 0;
  for (int k = 0; k < 20; ++k) {
    const Vec3 di = random_direction(random);
    const Vec3 dr = bistatic ? Vec3((di + 0.4 * random_direction(random)).normalized()) : di;
    const auto section = sampled.section(di, dr);
    if (!section) continue;
    ++found;
    const CrossSection truth = cross_section(target, visibility, di, dr);
    EXPECT_LE(section->sigma.bound, relative * section->sigma.value);
    EXPECT_LE(std::abs(section->sigma.value - truth.sigma.value), section->sigma.bound) << k;
    EXPECT_NEAR(section->seen_area, truth.seen_area, 2.0 * relative * truth.seen_area);
  }
  EXPECT_GT(found, 10);
}

}  // namespace lrcs
