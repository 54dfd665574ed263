#include "lrcs/grazing_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lrcs/placement.h"
#include "lrcs/sampled_sections.h"
#include "test_targets.h"

namespace lrcs {
namespace {

const Vec3 up = Vec3::UnitZ();

double doubtful_part(double cos_i, double width, const Vec3& to_receiver = up) {
  FacetMesh mesh;
  add_plate(mesh, {0, 0, 0}, {2, 0, 0}, {0, width, 0});
  measure_facets(mesh);
  GrazingLight grazing(mesh, 1.0);
  grazing.look_along({std::sqrt(1.0 - cos_i * cos_i), 0, cos_i}, to_receiver);
  return grazing.doubtful_part(0);
}

TEST(GrazingLight, IsDoubtfulAsFarAsAShadowMayBeOff) {
  const double height = 0.2 / std::hypot(2.0, 0.1);
  EXPECT_NEAR(doubtful_part(1e-3, 0.1), 2.0 * float_error / (1e-3 * height), 1e-9);
  EXPECT_EQ(doubtful_part(1e-6, 0.1), 1.0);
  EXPECT_EQ(doubtful_part(0.02, 0.1), 0.0) << "not grazing";
}

TEST(GrazingLight, IsNotDoubtfulWhereTheSideIsKnown) {
  EXPECT_EQ(doubtful_part(0.0, 0.1), 0.0) << "exactly edge-on";
  EXPECT_EQ(doubtful_part(-1e-6, 0.1), 0.0) << "lit from behind";
  EXPECT_EQ(doubtful_part(-1e-6, 0.1, -up), 1.0);
  EXPECT_EQ(doubtful_part(-1e-16, 0.1), 1.0) << "either side, as far as doubles tell";
}

// Long bodies along x whose sides the transmitter grazes: they bulge by less than rays tell, and each shades the next.
// Wu's model returns fully at grazing light.
TEST(GrazingLight, KeepsBoundsHonestOfRowsInTheTransmittersPlane) {
  std::vector<std::pair<double, double>> profile{{0.0, 0.0}};
  for (int k = 0; k <= 40; ++k) profile.emplace_back(0.3 + 1e-7 * ((k * 7) % 5), 0.05 * k);
  profile.emplace_back(0.0, 2.0);
  const FacetMesh body = revolved(profile, 40);
  FacetMesh mesh = body;
  append(mesh, body, {0.5, 0.7, 0.3});
  const Target target = target_of(mesh, library("metal-skin-5p"));
  const SampledSections sampled(target, 1e-2, true);
  const Visibility visibility(target.mesh);
  int found = 0;
  for (int k = 0; k < 24; ++k) {
    const double a = 2.0 * std::numbers::pi * k / 24, tilt = k % 2 == 0 ? 0.0 : 0.5;
    const Vec3 dr(std::cos(tilt) * std::cos(a), std::cos(tilt) * std::sin(a), std::sin(tilt));
    for (const Vec3& di : {up, Vec3(-up), Vec3(-dr.y(), dr.x(), dr.z())}) {
      const auto section = sampled.section(di, dr);
      if (!section) continue;
      ++found;
      const double truth = cross_section(target, visibility, di, dr).sigma.value;
      EXPECT_LE(std::abs(section->sigma.value - truth), section->sigma.bound) << k;
    }
  }
  EXPECT_GT(found, 10);
}

}  // namespace
}  // namespace lrcs
