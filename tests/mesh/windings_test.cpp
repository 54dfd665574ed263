#include "mesh/windings.h"

#include <gtest/gtest.h>

#include "made_meshes.h"

namespace lrcs {
namespace {

using FacetNumbers = std::vector<std::uint32_t>;

FacetMesh strip(std::uint32_t squares, const FacetNumbers& turned) {
  std::vector<Vec3> positions;
  Triangles facets;
  for (std::uint32_t k = 0; k <= squares; ++k)
    for (const double y : {0.0, 1.0}) positions.emplace_back(k, y, 0.0);
  for (std::uint32_t k = 0; k < squares; ++k) {
    facets.push_back({2 * k, 2 * k + 2, 2 * k + 3});
    facets.push_back({2 * k, 2 * k + 3, 2 * k + 1});
  }
  for (const std::uint32_t k : turned) std::swap(facets[k][0], facets[k][1]);
  return mesh_of(positions, facets);
}

TEST(FacetsAgainstMost, AreTheFewerOfAnOpenPiece) {
  EXPECT_EQ(facets_against_most(strip(5, {})), FacetNumbers{});
  EXPECT_EQ(facets_against_most(strip(5, {2, 7})), (FacetNumbers{2, 7}));
  EXPECT_EQ(facets_against_most(strip(5, {0, 1, 2, 3, 4, 5, 6})), (FacetNumbers{7, 8, 9}));
}

TEST(FacetsAgainstMost, FaceAgainstTheFirstWhereHalfOfThemDo) {
  EXPECT_EQ(facets_against_most(strip(2, {0, 1})), (FacetNumbers{2, 3}));
}

TEST(FacetsAgainstMost, AreSoughtPieceByPieceAndPartByPart) {
  const FacetMesh one = strip(3, {1});
  FacetMesh apart = strip(3, {0, 1, 2, 4, 5});
  for (Vec3& p : apart.positions) p.z() += 1.0;
  EXPECT_EQ(facets_against_most(joined(one, apart)), (FacetNumbers{1, 9}));
  FacetMesh parts = strip(2, {2, 3});
  parts.part.names = {"left", "right"};
  parts.part.of = {0, 0, 1, 1};
  EXPECT_EQ(facets_against_most(parts), FacetNumbers{});
}

TEST(FacetsAgainstMost, AreNoneOfAMoebiusBand) {
  EXPECT_EQ(facets_against_most(moebius(9)), FacetNumbers{});
}

}  // namespace
}  // namespace lrcs
