#include "mesh/enclosure.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "made_meshes.h"

namespace lrcs {
namespace {

// An L of three unit cubes, as one shell: its box holds a corner that it does not.
FacetMesh bracket() {
  return mesh_of({{0, 0, 0},
                  {2, 0, 0},
                  {2, 1, 0},
                  {1, 1, 0},
                  {1, 2, 0},
                  {0, 2, 0},
                  {0, 0, 1},
                  {2, 0, 1},
                  {2, 1, 1},
                  {1, 1, 1},
                  {1, 2, 1},
                  {0, 2, 1}},
                 {{0, 3, 1},   {1, 3, 2},  {0, 5, 3},  {3, 5, 4},   {6, 7, 9}, {7, 8, 9}, {6, 9, 11},
                  {9, 10, 11}, {0, 1, 7},  {0, 7, 6},  {1, 2, 8},   {1, 8, 7}, {2, 3, 9}, {2, 9, 8},
                  {3, 4, 10},  {3, 10, 9}, {4, 5, 11}, {4, 11, 10}, {5, 0, 6}, {5, 6, 11}});
}

std::vector<bool> inside(const FacetMesh& mesh) {
  const std::vector<ClosedShell> shells = closed_shells(mesh);
  Enclosure enclosure(mesh, shells);
  std::vector<bool> found;
  for (std::size_t k = 0; k < shells.size(); ++k) found.push_back(enclosure.is_inside_another(k));
  return found;
}

TEST(Enclosure, FindsABoxInABoxWhicheverWayTheyFace) {
  const FacetMesh outer = box({0, 0, 0}, {3, 3, 3});
  const FacetMesh inner = box({1, 1, 1}, {2, 2, 2});
  for (const FacetMesh& a : {outer, reversed(outer)}) {
    for (const FacetMesh& b : {inner, reversed(inner)}) EXPECT_EQ(inside(joined(a, b)), (std::vector{false, true}));
  }
}

TEST(Enclosure, DoesNotTakeABoxInTheCornerOfABracketForInside) {
  EXPECT_EQ(closed_shells(bracket()).at(0).volume, 3.0);
  EXPECT_EQ(inside(joined(bracket(), box({1.2, 1.2, 0.2}, {1.8, 1.8, 0.8}))), (std::vector{false, false}));
  EXPECT_EQ(inside(joined(bracket(), box({0.2, 1.2, 0.2}, {0.8, 1.8, 0.8}))), (std::vector{false, true}));
}

TEST(Enclosure, AnswersForThousandsOfBoxesInABox) {
  FacetMesh mesh = box({-1, -1, -1}, {40, 40, 1});
  for (int k = 0; k < 40 * 40; ++k) {
    const Vec3 low(k % 40, k / 40, 0);
    mesh = joined(std::move(mesh), reversed(box(low, low + Vec3(0.5, 0.5, 0.5))));
  }
  const std::vector<bool> found = inside(mesh);
  EXPECT_EQ(std::count(found.begin(), found.end(), true), 1600);
}

}  // namespace
}  // namespace lrcs
