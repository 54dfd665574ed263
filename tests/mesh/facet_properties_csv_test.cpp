#include "mesh/facet_properties_csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "made_meshes.h"
#include "mesh/repair.h"
#include "tests/base/gzip.h"

namespace lrcs {
namespace {

using testing::ElementsAre;

// Three polygons: a square of two facets, a facet, and one without area.
FacetMesh three_polygons() {
  return mesh_of_file("a.off", "OFF\n5 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 2 0\n4 0 1 2 3\n3 1 2 4\n3 0 1 1\n");
}

FacetMesh with_table(const std::string& table) {
  const Folder folder;
  FacetMesh mesh = three_polygons();
  add_facet_properties(mesh, folder.write("a.csv", table));
  return mesh;
}

std::string complaint(const std::string& table) {
  const Folder folder;
  FacetMesh mesh = three_polygons();
  mesh.properties = {{"coating", {{0, 0, 0, 0}, {"3"}}}};
  try {
    add_facet_properties(mesh, folder.write("a.csv", table));
    return "";
  } catch (const InputError& error) {
    EXPECT_EQ(mesh.properties.size(), 1U);
    return std::string(error.what()).substr(folder.path().string().size() + 1);
  }
}

TEST(FacetPropertiesCsv, GivesFacetsTheWordsOfTheirPolygons) {
  const FacetMesh mesh = with_table("# by hand\n\nfacet,zone, side\n2,hot,a\n# cold\n0 , \"warm side\",b\n");
  ASSERT_EQ(mesh.properties.size(), 2U);
  EXPECT_EQ(mesh.properties[0].name, "zone");
  EXPECT_THAT(mesh.properties[0].values.names, ElementsAre("warm side", "", "hot"));
  EXPECT_THAT(mesh.properties[0].values.of, ElementsAre(0, 0, 1, 2));
  EXPECT_EQ(mesh.properties[1].name, "side");
  EXPECT_THAT(mesh.properties[1].values.names, ElementsAre("b", "", "a"));
}

TEST(FacetPropertiesCsv, StaysWithFacetsThroughRepair) {
  FacetMesh mesh = with_table("facet,zone\n0,a\n1,b\n2,c\n");
  EXPECT_EQ(repair(mesh).degenerate, 1U);
  EXPECT_THAT(mesh.properties[0].values.of, ElementsAre(0, 0, 1));
}

TEST(FacetPropertiesCsv, IsReadWithWindowsLineEndsAByteOrderMarkAndCompressed) {
  for (const std::string& table : {std::string("\xef\xbb\xbf"
                                               "facet,zone\r\n1,x\r\n"),
                                   gzip("facet,zone\n1,x")})
    EXPECT_THAT(with_table(table).properties.at(0).values.of, ElementsAre(0, 0, 1, 0));
}

TEST(BadFacetPropertiesCsv, HasAHeaderThatIsNone) {
  EXPECT_EQ(complaint(""), "a.csv:1:1: expected column names: facet,NAME[,NAME...], found the end of the file");
  EXPECT_EQ(complaint("# nothing\n"),
            "a.csv:2:1: expected column names: facet,NAME[,NAME...], found the end of the file");
  EXPECT_EQ(complaint("zone,facet\n"), "a.csv:1:1: expected the column facet first, found 'zone'");
  EXPECT_EQ(complaint("facet\n0\n"), "a.csv:1:6: expected the name of a property, found the end of the line");
  EXPECT_EQ(complaint("facet,a,\n0,1,2\n"), "a.csv:1:9: expected the name of a property");
  EXPECT_EQ(complaint("facet,a,a\n"), "a.csv:1:9: facets have a property 'a' already");
  EXPECT_EQ(complaint("facet,a,coating\n"), "a.csv:1:9: facets have a property 'coating' already");
}

TEST(BadFacetPropertiesCsv, HasAFacetThatIsNoneOrComesAgain) {
  const std::string expected = "expected the number of a facet, 0 to 2, found ";
  EXPECT_EQ(complaint("facet,a\n0,x\n3,x\n"), "a.csv:3:1: " + expected + "'3'");
  EXPECT_EQ(complaint("facet,a\n-1,x\n"), "a.csv:2:1: " + expected + "'-1'");
  EXPECT_EQ(complaint("facet,a\n1.0,x\n"), "a.csv:2:1: " + expected + "'1.0'");
  EXPECT_EQ(complaint("facet,a\n one,x\n"), "a.csv:2:2: " + expected + "'one'");
  EXPECT_EQ(complaint("facet,a\n,x\n"), "a.csv:2:1: " + expected + "''");
  EXPECT_EQ(complaint("facet,a\n99999999999999999999,x\n"), "a.csv:2:1: " + expected + "'99999999999999999999'");
  EXPECT_EQ(complaint("facet,a\n2,x\n\n2,x\n"), "a.csv:4:1: facet 2 again (first on line 2)");
}

TEST(BadFacetPropertiesCsv, HasRowsOfOtherWidth) {
  EXPECT_EQ(complaint("facet,a,b\n0,x\n"), "a.csv:2:4: expected a word for b, found the end of the line");
  EXPECT_EQ(complaint("facet,a,b\n0,x,y,z\n"), "a.csv:2:7: expected 3 cells, found more");
  EXPECT_EQ(complaint("facet,a,b\n0,x,y,\n"), "a.csv:2:7: expected 3 cells, found more");
}

TEST(BadFacetPropertiesCsv, IsAFolder) {
  const Folder folder;
  FacetMesh mesh = three_polygons();
  EXPECT_THROW(add_facet_properties(mesh, folder.path()), InputError);
}

TEST(BadFacetPropertiesCsv, IsNeverMoreThanAnInputErrorWhateverBytesAreChanged) {
  std::mt19937_64 random(21);
  const std::string good = "facet,zone,side\n0,hot,a\n1,\"cold\",b\n2,,c\n";
  int refused = 0;
  for (int k = 0; k < 300; ++k) {
    std::string bytes = good;
    for (std::size_t flips = 1 + random() % 4; flips > 0; --flips)
      bytes[random() % bytes.size()] = k % 2 == 0 ? good[random() % good.size()] : static_cast<char>(random());
    const std::string wrong = complaint(bytes);
    EXPECT_EQ(wrong.find('\n'), std::string::npos);
    refused += wrong.empty() ? 0 : 1;
  }
  EXPECT_GT(refused, 50);
}

}  // namespace
}  // namespace lrcs
