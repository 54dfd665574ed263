#include "mesh/read_mesh.h"

#include <gtest/gtest.h>

#include <bit>

#include "mesh_files.h"
#include "tests/base/gzip.h"

namespace lrcs {
namespace {

// The same triangles, corner by corner.
void expect_same_surface(const FacetMesh& a, const FacetMesh& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_EQ(a.corners(k), b.corners(k)) << "facet " << k;
}

// Corners that no short decimal and no float holds.
FacetMesh odd_box() {
  return box({0.1, -1.0 / 3.0, 1e-17}, {1e6 / 7.0, 2.2250738585072014e-308, 4.9e20});
}

FacetMesh float_box() {
  return box({-0.25, 0.5, 1024.0}, {0.75, 1.5, 4096.0});
}

TEST(ReadMesh, ReadsBackEveryFormat) {
  expect_same_surface(mesh_of_file("a.stl", text_stl(odd_box())), odd_box());
  expect_same_surface(mesh_of_file("a.stl", binary_stl(float_box())), float_box());
  expect_same_surface(mesh_of_file("a.obj", obj(odd_box())), odd_box());
  expect_same_surface(mesh_of_file("a.off", off(odd_box())), odd_box());
  expect_same_surface(mesh_of_file("a.ply", ply(odd_box(), "ascii")), odd_box());
  expect_same_surface(mesh_of_file("a.ply", ply(odd_box(), "binary_little_endian")), odd_box());
  expect_same_surface(mesh_of_file("a.ply", ply(odd_box(), "binary_big_endian")), odd_box());
}

TEST(ReadMesh, KnowsTheFormatByTheContentWhateverTheName) {
  for (const std::string& content : every_format(float_box())) {
    for (const std::string name : {"a", "a.stl", "a.obj", "a.ply", "a.off", "a.dat"})
      expect_same_surface(mesh_of_file(name, content), float_box());
  }
}

TEST(ReadMesh, ReadsTheSameWithWindowsAndOldMacLineEnds) {
  for (const std::string line_end : {"\r\n", "\r"}) {
    for (const std::string& content : {text_stl(odd_box()), obj(odd_box()), off(odd_box()), ply(odd_box(), "ascii")}) {
      std::string other;
      for (const char c : content) other += c == '\n' ? line_end : std::string(1, c);
      expect_same_surface(mesh_of_file("a", other), odd_box());
    }
  }
}

TEST(ReadMesh, ReadsABinaryStlWhoseHeaderBeginsWithSolid) {
  expect_same_surface(mesh_of_file("a.stl", binary_stl(float_box(), "solid of a text? no")), float_box());
}

TEST(ReadMesh, ReadsABinaryStlWhoseHeaderIsAWholeTextStl) {
  expect_same_surface(mesh_of_file("a.stl", binary_stl(float_box(), "solid\nendsolid\n")), float_box());
}

TEST(ReadMesh, PassesOverAByteOrderMark) {
  expect_same_surface(mesh_of_file("a.obj", "\xef\xbb\xbf" + obj(odd_box())), odd_box());
}

TEST(ReadMesh, RoundsDecimalsToTheNearestDouble) {
  const FacetMesh mesh = mesh_of_file("a.obj", "v 0.1 +0.30000000000000004 1e23\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(mesh.positions[0], Vec3(0.1, 0.1 + 0.2, 1e23));
}

TEST(ReadMesh, WidensTheFloatsOfABinaryStlExactly) {
  const FacetMesh mesh = mesh_of_file("a.stl", binary_stl(box({0.1, 0.1, 0.1}, {1, 1, 1})));
  EXPECT_EQ(mesh.positions[0].x(), static_cast<double>(0.1F));
}

TEST(ReadTextStl, MakesAPartOfEverySolidNameThatHasFacets) {
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
  const FacetMesh mesh =
      mesh_of_file("a.stl", "solid left wing \n" + facet + "endsolid left wing\nSOLID\n" + facet + facet +
                                "ENDSOLID\nsolid empty\nendsolid\nsolid left wing\n" + facet + "endsolid other\n");
  EXPECT_EQ(mesh.part.names, (std::vector<std::string>{"left wing", ""}));
  EXPECT_EQ(mesh.part.of, (std::vector<std::uint32_t>{0, 1, 1, 0}));
  EXPECT_EQ(mesh.file_material.names, std::vector<std::string>{""});
}

TEST(ReadTextStl, GoesByTheWindingAndCountsStoredNormalsAgainstIt) {
  for (const std::string normal : {"normal 0 0 -1", "normal nan nan nan", "normal", "", "normal 0 0"}) {
    const FacetMesh mesh = mesh_of_file("a.stl", "solid\nfacet " + normal +
                                                     "\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                                                     "endloop\nendfacet\nendsolid\n");
    EXPECT_EQ(mesh.normals[0], Vec3(0, 0, 1)) << normal;
    EXPECT_EQ(mesh.normals_against, normal == "normal 0 0 -1" ? 1U : 0U) << normal;
  }
}

TEST(ReadTextStl, CutsAFacetOfFourVerticesAsAFan) {
  const FacetMesh mesh =
      mesh_of_file("a.stl",
                   "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n"
                   "vertex 0 1 0\nendloop\nendfacet\nendsolid\n");
  EXPECT_EQ(mesh.facets, (Triangles{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(mesh.source_facet, (std::vector<std::uint32_t>{0, 0}));
}

constexpr std::string_view four = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(ReadObj, MakesPartsOfObjectsAndGroupsAndMaterialsOfUsemtl) {
  const FacetMesh mesh =
      mesh_of_file("a.obj", "mtllib nowhere.mtl\n" + std::string(four) +
                                "f 1 2 3\no tail fin\nusemtl red\nf 1 2 3\ng rudder # not a comment\n"
                                "usemtl blue\nf 1 3 4\no tail fin\nf 1 2 4\n");
  EXPECT_EQ(mesh.part.names, (std::vector<std::string>{"", "tail fin", "rudder # not a comment"}));
  EXPECT_EQ(mesh.part.of, (std::vector<std::uint32_t>{0, 1, 2, 1}));
  EXPECT_EQ(mesh.file_material.names, (std::vector<std::string>{"", "red", "blue"}));
  EXPECT_EQ(mesh.file_material.of, (std::vector<std::uint32_t>{0, 1, 2, 2}));
}

TEST(ReadObj, UnderstandsEveryWayToNameAVertex) {
  const FacetMesh mesh =
      mesh_of_file("a.obj", std::string(four) + "f 1/1 2//7 3/1/2\nf -4 -3 -2 # last four\nf 1 2 \\\n 3 \\\r\n4\n");
  EXPECT_EQ(mesh.facets, (Triangles{{0, 1, 2}, {0, 1, 2}, {0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(mesh.source_facet, (std::vector<std::uint32_t>{0, 1, 2, 2}));
}

TEST(ReadObj, TakesFacesBeforeTheirVertices) {
  EXPECT_EQ(mesh_of_file("a.obj", "f 1 2 3\n" + std::string(four)).size(), 1U);
}

TEST(ReadObj, PassesOverColoursEvenIfTheyAreNoNumbers) {
  const FacetMesh mesh = mesh_of_file("a.obj", "v 0 0 0 nan nan nan\nv 1 0 0 1 1 1\nv 0 1 0 red\nf 1 2 3\n");
  EXPECT_EQ(mesh.size(), 1U);
}

TEST(ReadObj, CutsANonConvexPolygonInside) {
  const FacetMesh mesh = mesh_of_file("a.obj", "v 0 0 0\nv 2 -1 0\nv 0.5 0 0\nv 2 1 0\nf 2 3 4 1\n");
  EXPECT_DOUBLE_EQ(mesh.areas[0] + mesh.areas[1], 0.5);
}

TEST(ReadPly, PassesOverOtherElementsAndProperties) {
  const FacetMesh mesh = mesh_of_file(
      "a.ply",
      "ply\nformat ascii 1.0\ncomment made by hand\nobj_info none\nelement camera 1\nproperty list int float view\n"
      "element vertex 3\nproperty uchar red\nproperty double z\nproperty double y\nproperty double x\nelement face 1\n"
      "property list uchar float texcoord\nproperty list uint ushort vertex_index\nproperty float quality\n"
      "element edge 1\nproperty int a\nend_header\n3 1 2 nan\n\n255 3 2 1\n1 6 5 4\n2 9 8 7\n2 0.5 0.5 3 0 1 2 "
      "inf\n7\n");
  EXPECT_EQ(mesh.positions[0], Vec3(1, 2, 3));
  EXPECT_EQ(mesh.facets, (Triangles{{0, 1, 2}}));
}

// A quadrilateral and two triangles; what faces have before and behind their corners.
std::string ply_with_words(const std::string& before, const std::string& behind, const std::string& rows) {
  return "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
         "element face 3\n" +
         before + "property list uchar int vertex_indices\n" + behind + "end_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n" +
         rows;
}

TEST(ReadPly, TakesColoursOfFacesAndTheirOtherWholeNumbersAsProperties) {
  const FacetMesh mesh = mesh_of_file(
      "a.ply",
      ply_with_words("property short zone\nproperty uchar blue\n",
                     "property uchar red\nproperty uchar alpha\nproperty float quality\nproperty uchar green\n"
                     "property list uchar int more\n",
                     "-7 0 4 0 1 2 3 255 9 nan 128 1 5\n12 51 3 0 1 2 0 9 1 0 0\n-7 0 3 0 2 3 255 8 1 128 0\n"));
  EXPECT_EQ(mesh.colour.names, (std::vector<std::string>{"#ff8000", "#000033"}));
  EXPECT_EQ(mesh.colour.of, (std::vector<std::uint32_t>{0, 0, 1, 0}));
  ASSERT_EQ(mesh.properties.size(), 2U);
  EXPECT_EQ(mesh.properties[0].name, "zone");
  EXPECT_EQ(mesh.properties[0].values.names, (std::vector<std::string>{"-7", "12"}));
  EXPECT_EQ(mesh.properties[0].values.of, (std::vector<std::uint32_t>{0, 0, 1, 0}));
  EXPECT_EQ(mesh.properties[1].name, "alpha");
  EXPECT_EQ(mesh.properties[1].values.names, (std::vector<std::string>{"9", "8"}));
}

TEST(ReadPly, TakesPartsOfAColourThatAreNoBytesAsProperties) {
  const FacetMesh mesh =
      mesh_of_file("a.ply", ply_with_words("", "property uchar red\nproperty int green\nproperty uchar blue\n",
                                           "3 0 1 2 1 2 3\n3 0 1 2 1 2 3\n3 0 1 2 1 2 3\n"));
  EXPECT_TRUE(mesh.colour.of.empty());
  ASSERT_EQ(mesh.properties.size(), 3U);
  EXPECT_EQ(mesh.properties[1].values.names, (std::vector<std::string>{"2"}));
}

TEST(ReadPly, TakesWordsOfBinaryFacesInBothByteOrders) {
  for (const bool big : {false, true}) {
    std::string file = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                       "_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                       "element face 1\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
                       "property list uchar int vertex_indices\nproperty int zone\nproperty uint key\nend_header\n";
    for (const float x : {0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F}) file += bytes_of(x, big);
    file += "\xff\x10\x20\x03";
    for (const std::int32_t index : {0, 1, 2}) file += bytes_of(index, big);
    file += bytes_of(std::int32_t{-1}, big) + bytes_of(std::uint32_t{4294967295U}, big);
    const FacetMesh mesh = mesh_of_file("a.ply", file);
    EXPECT_EQ(mesh.colour.names, (std::vector<std::string>{"#ff1020"}));
    EXPECT_EQ(mesh.properties.at(0).values.names, (std::vector<std::string>{"-1"}));
    EXPECT_EQ(mesh.properties.at(1).values.names, (std::vector<std::string>{"4294967295"}));
  }
}

TEST(ReadOff, PassesOverCommentsColoursAndNormals) {
  const std::string rows = "3 1 0 # counts\n\n0 0 0 1 0 0 1\n# between\n1 0 0 9 9\n0 1 0\n3 0 1 2 255 0 0\n";
  for (const std::string keyword : {"OFF\n", "COFF\n# rem\n", "NOFF ", "# first\nOFF\n\n", "STCNOFF\n"})
    EXPECT_EQ(mesh_of_file("a.off", keyword + rows).facets, (Triangles{{0, 1, 2}})) << keyword;
}

TEST(ReadOff, TakesRowsWhoseEndIsContinuedOrACommentOrMissing) {
  for (const std::string row : {"3 0 \\\n 1 2", "3 0 1 2 # end", "3 0\v1\f2 \\", "+3 0 1 2 red"})
    EXPECT_EQ(mesh_of_file("a.off", "OFF\n3 1 0\n0 0 0\n1 \\\r\n0 0\n0 1 0 # last \\\n" + row).facets,
              (Triangles{{0, 1, 2}}))
        << row;
}

TEST(ReadMesh, ReadsWhatIsCompressed) {
  const Folder folder;
  for (const std::string& content : {text_stl(unit_box()), binary_stl(unit_box()), obj(unit_box())})
    EXPECT_EQ(read_mesh(folder.write("a.stl.gz", gzip(content))).size(), 12U);
}

}  // namespace
}  // namespace lrcs
