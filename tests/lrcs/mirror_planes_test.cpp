#include "lrcs/mirror_planes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/lrcs/test_targets.h"

namespace lrcs {
namespace {

constexpr MirrorPlanes all{true, true, true};

MirrorPlanes planes_of(const Target& target) {
  return mirror_planes(target, all, Visibility(target.mesh).coincident_facets());
}

// Facets anywhere and their images in the plane where coordinate `axis` is `at`.
FacetMesh doubled(FacetMesh mesh, Eigen::Index axis, double at) {
  const std::size_t facets = mesh.size();
  for (std::size_t k = 0; k < facets; ++k) {
    auto p = mesh.corners(k);
    for (Vec3& x : p) x[axis] = 2.0 * at - x[axis];
    add_triangle(mesh, p[0], p[2], p[1]);
  }
  return mesh;
}

// Coordinates of few bits, so that those of the image are doubles.
FacetMesh coarse_soup(std::mt19937_64& random, int facets) {
  FacetMesh mesh = random_soup(random, facets);
  for (Vec3& p : mesh.positions)
    for (double& x : p) x = std::nearbyint(x * 0x1p20) / 0x1p20;
  return mesh;
}

TEST(MirrorPlanes, AreFoundWhereverTheyLie) {
  std::mt19937_64 random(51);
  for (int axis = 0; axis < 3; ++axis)
    for (const double at : {0.0, 3.25, -1.0 / 3.0}) {
      const bool exact = at != -1.0 / 3.0;
      MirrorPlanes expected{};
      expected[static_cast<std::size_t>(axis)] = exact;
      const FacetMesh mesh = doubled(coarse_soup(random, 40), axis, at);
      EXPECT_EQ(planes_of(target_of(mesh, lambert(0.5))), expected) << axis << " " << at;
    }
}

TEST(MirrorPlanes, AreLostWithTheLastBitOfAVertexTheWindingOrTheMaterialOfAFacet) {
  std::mt19937_64 random(52);
  const Target target = target_of(doubled(coarse_soup(random, 40), 1, 0.0), lambert(0.5));
  const MirrorPlanes y{false, true, false}, none{};
  ASSERT_EQ(planes_of(target), y);
  Target moved = target;
  double& x = moved.mesh.positions[17].z();
  x = std::nextafter(x, 10.0);
  measure_facets(moved.mesh);
  EXPECT_EQ(planes_of(moved), none);
  Target turned = target;
  std::swap(turned.mesh.facets[3][0], turned.mesh.facets[3][1]);
  measure_facets(turned.mesh);
  EXPECT_EQ(planes_of(turned), none);
  Target painted = target;
  painted.materials.push_back({"other", lambert(0.1), 0.0, ""});
  painted.material[5] = 1;
  EXPECT_EQ(planes_of(painted), none);
  painted.material[5 + 40] = 1;
  EXPECT_EQ(planes_of(painted), y);
}

// Of facets on one another the first counts: a white one over a black one, and over there the black one first.
TEST(MirrorPlanes, AreLostWhereCoincidentFacetsComeInAnotherOrder) {
  const Vec3 a(1, 1, 0), b(3, 1, 0), c(1, 3, 0), m(-1, 1, 1);
  const auto image = [](const Vec3& p) { return Vec3(-p.x(), p.y(), p.z()); };
  for (const bool same_order : {true, false}) {
    FacetMesh mesh;
    add_triangle(mesh, a, b, c);
    add_triangle(mesh, a, b, c);
    for (int k = 0; k < 2; ++k) add_triangle(mesh, image(a), image(c), image(b));
    Target target = target_of(mesh, lambert(1.0));
    target.materials.push_back({"black", lambert(0.0), 0.0, ""});
    target.material = {0, 1, 0, 1};
    if (!same_order) std::swap(target.material[2], target.material[3]);
    EXPECT_EQ(planes_of(target)[0], same_order);
  }
}

TEST(FirstAlike, FindsRepeatedAndMirroredDirections) {
  std::vector<Aspect> aspects;
  for (const double azimuth : {0.0, 10.0, 170.0, 190.0, 350.0, 360.0, -10.0, 45.0, 135.0})
    aspects.push_back(aspect_of({azimuth, 0.0}, {}));
  aspects.push_back(aspect_of({30.0, 90.0}, {}));
  aspects.push_back(aspect_of({70.0, 90.0}, {}));
  using Rows = std::vector<std::size_t>;
  EXPECT_EQ(first_alike(aspects, {}), (Rows{0, 1, 2, 3, 4, 0, 4, 7, 8, 9, 9}));
  EXPECT_EQ(first_alike(aspects, {false, true, false}), (Rows{0, 1, 2, 2, 1, 0, 1, 7, 8, 9, 9}));
  EXPECT_EQ(first_alike(aspects, {true, true, false}), (Rows{0, 1, 1, 1, 1, 0, 1, 7, 7, 9, 9}));
  EXPECT_EQ(planes_of_use(aspects), (MirrorPlanes{true, true, false}));
}

TEST(FirstAlike, TurnsBothDirectionsTogether) {
  const Vec3 di = Vec3(3, 2, 1).normalized(), dr = Vec3(1, 2, 3).normalized();
  const auto image = [](const Vec3& d) { return Vec3(d.x(), -d.y(), d.z()); };
  const std::vector<Aspect> aspects{
      {{}, {}, di, dr}, {{}, {}, image(di), dr}, {{}, {}, image(di), image(dr)}, {{}, {}, dr, di}};
  EXPECT_EQ(first_alike(aspects, {true, true, true}), (std::vector<std::size_t>{0, 1, 0, 3}));
}

}  // namespace
}  // namespace lrcs
