#include "lrcs/unmet_returns.h"

#include <gtest/gtest.h>

#include <numbers>

#include "lrcs/sampled_sections.h"
#include "test_targets.h"

namespace lrcs {
namespace {

constexpr double white = 1.0 / std::numbers::pi;
const Vec3 face_on = Vec3::UnitZ();
const Vec3 slanted = Vec3(0.3, 0, 1).normalized();

// Dark but for a small plate.
Target spotted_plate(double side_of_spot) {
  FacetMesh mesh;
  add_plate(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  add_plate(mesh, {0.3, 0.4, 0.1}, {side_of_spot, 0, 0}, {0, side_of_spot, 0});
  Target target = target_of(mesh, lambert(0.001));
  target.materials.push_back({"white", lambert(1.0), 0.0, ""});
  target.material[2] = target.material[3] = 1;
  return target;
}

TEST(UnmetReturns, AreWhatBrighterFacetsReturnInAllIfThatIsLittle) {
  const Target target = spotted_plate(0.01);
  UnmetReturns unmet(target);
  const double largest = 0.001 * white;
  EXPECT_NEAR(unmet.beyond(largest, face_on, face_on, 0.1), 0.01 * 0.999 * white, 1e-3 * 0.01 * white);
  const double cosine = slanted.z();
  EXPECT_NEAR(unmet.beyond(largest, face_on, slanted, 0.1), 0.01 * (1.0 - 0.001) * white * cosine, 1e-12);
}

TEST(UnmetReturns, AreFourPlacesAtTheMost) {
  const Target target = spotted_plate(0.5);
  UnmetReturns unmet(target);
  const double most = 4.0 * 0.999 * white;
  EXPECT_NEAR(unmet.beyond(0.001 * white, face_on, face_on, 0.1), most, 1e-12);
  EXPECT_NEAR(unmet.beyond(0.001 * white, face_on, slanted, 0.1), most, 1e-12);
}

TEST(UnmetReturns, AreNoneOfWhatIsMetOrFacesAway) {
  Target target = spotted_plate(0.01);
  UnmetReturns unmet(target);
  EXPECT_EQ(unmet.beyond(white, face_on, face_on, 0.1), 0.0);
  EXPECT_EQ(unmet.beyond(white, face_on, slanted, 0.1), 0.0);
  EXPECT_EQ(unmet.beyond(0.0, face_on, -slanted, 0.1), 0.0) << "lit from behind";
  target.sides = Sides::front;
  EXPECT_EQ(UnmetReturns(target).beyond(0.0, -face_on, -face_on, 0.1), 0.0);
}

// Two dark bodies, and before them bright plates too small to be met that return a twentieth of all.
Target glints(std::mt19937_64& random, const Vec3& d, double contrast) {
  FacetMesh mesh = sphere(1.0, 20);
  append(mesh, sphere(0.7, 20), {1.2, 0.3, 0.2});
  const auto dark = static_cast<std::ptrdiff_t>(mesh.size());
  const double sigma = section_of(target_of(mesh, lambert(0.9 / contrast)), d, d).sigma.value;
  const Vec3 right = d.unitOrthogonal(), ahead = d.cross(right);
  std::uniform_real_distribution<double> off(-1.0, 1.0);
  const auto plates = static_cast<double>(1 + random() % 8);
  const double side = std::sqrt(0.05 * sigma / (4.0 * 0.9 * plates));
  for (int k = 0; k < plates; ++k)
    add_plate(mesh, 2.5 * d + off(random) * right + off(random) * ahead, side * right, side * ahead);
  Target target = target_of(mesh, lambert(0.9 / contrast));
  target.materials.push_back({"bright", lambert(0.9), 0.0, ""});
  std::fill(target.material.begin() + dark, target.material.end(), 1);
  return target;
}

TEST(UnmetReturns, KeepBoundsHonestAboutBrightFacetsThatNoPlaceMeets) {
  std::mt19937_64 random(11);
  for (const double contrast : {30.0, 300.0, 1000.0, 10000.0})
    for (int k = 0; k < 8; ++k) {
      const Vec3 d = random_direction(random);
      const Target target = glints(random, d, contrast);
      const auto sampled = SampledSections(target, 1e-2, false).section(d, d);
      EXPECT_TRUE(sampled || contrast > 30.0) << "they are met";
      if (!sampled) continue;
      EXPECT_LE(std::abs(sampled->sigma.value - section_of(target, d, d).sigma.value), sampled->sigma.bound)
          << contrast << ' ' << k;
    }
}

}  // namespace
}  // namespace lrcs
