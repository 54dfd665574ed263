#include "lrcs/facet_tree.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <random>

#include "lrcs/space_order.h"

namespace lrcs {
namespace {

// So many small facets anywhere in a cube, the size of which does not matter.
FacetMesh cloud(std::uint32_t facets, double size) {
  std::mt19937_64 random(facets);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto any = [&] { return Vec3(unit(random), unit(random), unit(random)); };
  FacetMesh mesh;
  for (std::uint32_t k = 0; k < facets; ++k) {
    const Vec3 at = any();
    for (int c = 0; c < 3; ++c) mesh.positions.emplace_back(size * (at + 0.01 * any()));
    mesh.facets.push_back({3 * k, 3 * k + 1, 3 * k + 2});
  }
  mesh.part.of.assign(facets, 0);
  mesh.part.names = {""};
  measure_facets(mesh);
  return mesh;
}

bool holds(const Box3& box, const Vec3& p) {
  return (box.low.array() <= p.array()).all() && (p.array() <= box.high.array()).all();
}

// Every node's facets are those of its two children, one after the other, and lie in its box.
void expect_tree(const FacetTree& tree, const Occluders& occluders) {
  const auto& nodes = tree.nodes();
  ASSERT_EQ(nodes.front().first, 0U);
  ASSERT_EQ(nodes.front().last, occluders.size());
  ASSERT_EQ(nodes.front().skip, nodes.size());
  for (std::uint32_t k = 0; k < nodes.size(); ++k) {
    const auto& node = nodes[k];
    for (std::uint32_t f = node.first; f < node.last; ++f)
      for (const std::uint32_t v : occluders.facets[f]) ASSERT_TRUE(holds(node.box, occluders.positions[v]));
    ASSERT_EQ(node.leaf, node.last - node.first <= space_leaf);
    if (node.leaf) {
      ASSERT_EQ(node.skip, k + 1);
      continue;
    }
    const auto &left = nodes[k + 1], &right = nodes[left.skip];
    ASSERT_EQ(left.first, node.first);
    ASSERT_EQ(left.last, right.first);
    ASSERT_EQ(right.last, node.last);
    ASSERT_EQ(right.skip, node.skip);
  }
}

TEST(FacetTree, PartsAnyNumberOfFacets) {
  for (const std::uint32_t facets : {1, 7, 8, 9, 10, 15, 16, 17, 18, 19, 31, 33, 100, 1000, 1023, 1025}) {
    const Occluders occluders(cloud(facets, 1.0));
    ASSERT_EQ(occluders.size(), facets);
    expect_tree(FacetTree(occluders), occluders);
  }
}

TEST(FacetTree, IsTheSameOnAnyNumberOfThreadsAndAtAnySize) {
  // Powers of two: the coordinates are the same but for their exponents.
  std::vector<std::uint32_t> original;
  for (const std::size_t threads : {1, 2, 5})
    for (const double size : {1.0, 0x1p-100, 0x1p266}) {
      const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, threads);
      const Occluders occluders(cloud(20000, size));
      expect_tree(FacetTree(occluders), occluders);
      if (original.empty()) original = occluders.original;
      EXPECT_EQ(occluders.original, original) << threads << " threads, size " << size;
    }
}

TEST(SpaceOrder, IsAPermutationWhateverThePoints) {
  for (const std::size_t count : {0, 1, 9, 5000}) {
    std::vector<std::vector<Vec3>> clouds{std::vector<Vec3>(count, Vec3(1.0, 2.0, 3.0)), {}, {}};
    for (std::size_t k = 0; k < count; ++k) {
      clouds[1].emplace_back(static_cast<double>(k), 0.0, 0.0);                                       // sorted
      clouds[2].emplace_back(0.0, static_cast<double>((k * 2654435761U) % 64), k == 0 ? 1e12 : 0.0);  // few values
    }
    for (const auto& points : clouds) {
      std::vector<std::uint32_t> order = space_order(points);
      ASSERT_EQ(order.size(), count);
      std::sort(order.begin(), order.end());
      for (std::uint32_t k = 0; k < count; ++k) ASSERT_EQ(order[k], k);
    }
  }
}

// The sum of the longest sides of the boxes of all leaves but the last, which may hold a point from afar.
double leaf_sides(const std::vector<Vec3>& points) {
  const auto order = space_order(points);
  const auto sides_below = [&](const auto& self, std::uint32_t first, std::uint32_t last) -> double {
    if (last - first > space_leaf)
      return self(self, first, middle_of(first, last)) + self(self, middle_of(first, last), last);
    Box3 box{points[order[first]], points[order[first]]};
    for (std::uint32_t k = first; k < last; ++k) {
      box.low = box.low.cwiseMin(points[order[k]]);
      box.high = box.high.cwiseMax(points[order[k]]);
    }
    return last == points.size() ? 0.0 : (box.high - box.low).maxCoeff();
  };
  return sides_below(sides_below, 0, static_cast<std::uint32_t>(points.size()));
}

TEST(SpaceOrder, IsNearlyAsCompactBesideAPointFarFromAllOthers) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Vec3> points;
  for (int k = 0; k < 4096; ++k) points.emplace_back(unit(random), unit(random), unit(random));
  const double near = leaf_sides(points);
  for (const double far : {1e3, 1e9, 1e12, 1e200}) {
    points.back() = Vec3(far, far, far);
    EXPECT_LT(leaf_sides(points), 1.25 * near) << far;
  }
}

TEST(SpaceOrder, HalvesAlongTheLongestSide) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<Vec3> points;
  for (int k = 0; k < 3001; ++k) points.emplace_back(unit(random), 3.0 * unit(random), unit(random));
  const auto order = space_order(points);
  const std::uint32_t middle = middle_of(0, 3001);
  double low = -10.0, high = 10.0;
  for (std::uint32_t k = 0; k < order.size(); ++k) {
    const double y = points[order[k]].y();
    if (k < middle)
      low = std::max(low, y);
    else
      high = std::min(high, y);
  }
  EXPECT_LE(low, high);
}

}  // namespace
}  // namespace lrcs
