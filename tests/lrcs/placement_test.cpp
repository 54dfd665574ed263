#include "lrcs/placement.h"

#include <gtest/gtest.h>

#include "test_targets.h"

namespace lrcs {
namespace {

TEST(Placement, CentresFacetsAndMakesTheirLargestSideOne) {
  FacetMesh mesh;
  add_box(mesh, {1, 2, 3}, {5, 4, 4});
  const Placement placement(mesh);
  EXPECT_EQ(placement.placed({1, 2, 3}), Vec3(-0.5, -0.25, -0.125));
  EXPECT_EQ(placement.placed({5, 4, 4}), Vec3(0.5, 0.25, 0.125));
}

TEST(Placement, DoesNotLookAtVerticesOfNoFacet) {
  FacetMesh mesh;
  add_box(mesh, {1, 2, 3}, {5, 4, 4});
  const Placement before(mesh);
  mesh.positions.push_back({1e5, 0, 0});
  mesh.positions.insert(mesh.positions.begin(), {-1e30, 0, 0});
  for (auto& facet : mesh.facets)
    for (std::uint32_t& k : facet) ++k;
  const Placement after(mesh);
  EXPECT_EQ(before.centre, after.centre);
  EXPECT_EQ(before.scale, after.scale);
}

TEST(Placement, OfNoFacetsIsNone) {
  const Placement placement{FacetMesh{}};
  EXPECT_EQ(placement.placed({1, 2, 3}), Vec3(1, 2, 3));
}

}  // namespace
}  // namespace lrcs
