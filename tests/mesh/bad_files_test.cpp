#include <gtest/gtest.h>

#include <random>

#include "mesh_files.h"

// One message for each way in which a file can be wrong, word by word; and that nothing but an InputError comes of
// noise.

namespace lrcs {
namespace {

constexpr const char* expected = "expected STEP, IGES, BREP, glTF, 3MF, VTP, VTU, STL, OBJ, PLY or OFF";

std::string stl(const std::string& loop) {
  return "solid a\nfacet normal 0 0 1\nouter loop\n" + loop + "endloop\nendfacet\nendsolid\n";
}

TEST(BadFile, IsEmpty) {
  EXPECT_EQ(complaint_about("a.stl", ""), std::string("a.stl: is empty, ") + expected);
}

TEST(BadFile, DoesNotExist) {
  const Folder folder;
  const auto file = folder.path() / "none.stl";
  try {
    const FacetMesh mesh = read_mesh(file);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), file.string() + ": cannot be read: No such file or directory");
  }
}

TEST(BadFile, IsAFolder) {
  const Folder folder;
  try {
    const FacetMesh mesh = read_mesh(folder.path());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), folder.path().string() + ": is a folder, expected a file");
  }
}

TEST(BadFile, IsUtf16) {
  const std::string utf16("\xff\xfe#\0v\0", 6);
  EXPECT_EQ(complaint_about("a.obj", utf16), "a.obj: is UTF-16 text, expected UTF-8 or ASCII");
}

TEST(BadFile, IsOfAFormatThatIsNotRead) {
  const std::string tail = std::string(", which is not read yet; ") + expected;
  EXPECT_EQ(complaint_about("a.vtp", "<VTKFile"), "a.vtp: is a VTK XML file" + tail);
}

TEST(BadFile, IsOfAFormatThatReadTargetReads) {
  const std::string message = ": is STEP, IGES, BREP, glTF, 3MF, VTP or VTU, expected STL, OBJ, PLY or OFF here";
  EXPECT_EQ(complaint_about("a.glb", std::string("glTF\2\0\0\0", 8)), "a.glb" + message);
  EXPECT_EQ(complaint_about("a.gltf", " {\"asset\": {}}"), "a.gltf" + message);
  EXPECT_EQ(complaint_about("a.stp", "ISO-10303-21;\nHEADER;\n"), "a.stp" + message);
  EXPECT_EQ(complaint_about("a.brep", "\nCASCADE Topology V1\n"), "a.brep" + message);
  EXPECT_EQ(complaint_about("a.igs", std::string(72, ' ') + "S      1\n"), "a.igs" + message);
}

TEST(BadFile, IsDamagedGzip) {
  EXPECT_EQ(complaint_about("a.stl", "\x1f\x8b\x08"), "a.stl: is compressed by gzip and cannot be unpacked: cut off");
}

TEST(BadFile, IsOfNoKnownFormat) {
  EXPECT_EQ(complaint_about("a.txt", "hello"), std::string("a.txt: is in no format known here, ") + expected);
  EXPECT_EQ(complaint_about("a.bin", std::string(300, '\0')),
            std::string("a.bin: is in no format known here, ") + expected);
}

TEST(BadFile, HoldsNoFacets) {
  const std::string message = ": holds no facets, expected at least one";
  EXPECT_EQ(complaint_about("a.stl", std::string(84, '\0')), "a.stl" + message);
  EXPECT_EQ(complaint_about("a.stl", "solid a\nendsolid a\n"), "a.stl" + message);
  EXPECT_EQ(complaint_about("a.obj", "v 0 0 0\n"), "a.obj" + message);
  EXPECT_EQ(complaint_about("a.off", "OFF\n0 0 0\n"), "a.off" + message);
}

TEST(BadTextStl, HasACoordinateThatIsNone) {
  EXPECT_EQ(complaint_about("a.stl", stl("vertex 0 0 0\nvertex 1 0 x\n")),
            "a.stl:5:12: expected a coordinate, a finite number, found 'x'");
  EXPECT_EQ(complaint_about("a.stl", stl("vertex 0 nan 0\n")),
            "a.stl:4:10: expected a coordinate, a finite number, found 'nan'");
  EXPECT_EQ(complaint_about("a.stl", stl("vertex 0 0 -inf\n")),
            "a.stl:4:12: expected a coordinate, a finite number, found '-inf'");
  EXPECT_EQ(complaint_about("a.stl", stl("vertex 0 0 1e300\n")),
            "a.stl:4:12: expected a coordinate of at most 1e100, found '1e300'");
  EXPECT_EQ(complaint_about("a.stl", stl("vertex 0 0\n")),
            "a.stl:4:11: expected a coordinate, a finite number, found the end of the line");
}

TEST(BadTextStl, HasAFacetOfTwoVertices) {
  EXPECT_EQ(complaint_about("a.stl", stl("vertex 0 0 0\nvertex 1 0 0\n")),
            "a.stl:6:1: expected at least 3 vertices, found 2");
}

TEST(BadTextStl, EndsTooEarly) {
  EXPECT_EQ(complaint_about("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"),
            "a.stl:5:1: expected 'vertex' or 'endloop', found the end of the file");
  EXPECT_EQ(complaint_about("a.stl", "solid a\nfacet"), "a.stl:2:6: expected 'outer loop', found the end of the file");
  EXPECT_EQ(complaint_about("a.stl", "solid a\n"),
            "a.stl:2:1: expected 'facet' or 'endsolid', found the end of the file");
}

TEST(BadTextStl, HasAWordThatDoesNotBelongThere) {
  EXPECT_EQ(complaint_about("a.stl", "solid a\nfaset normal 0 0 1\n"),
            "a.stl:2:1: expected 'facet' or 'endsolid', found 'faset'");
  EXPECT_EQ(complaint_about("a.stl", "solid a\nendsolid\n<html>\n"), "a.stl:3:1: expected 'solid', found '<html>'");
}

TEST(BadBinaryStl, HasAnotherSizeThanItsHeaderSays) {
  const std::string good = binary_stl(unit_box(), "solid");
  EXPECT_EQ(complaint_about("a.stl", good.substr(0, 600)),
            "a.stl: has 600 bytes, expected 684 for the 12 facets of its binary STL header");
  EXPECT_EQ(complaint_about("a.stl", good + "xy"),
            "a.stl: has 686 bytes, expected 684 for the 12 facets of its binary STL header");
  std::string huge = good;
  huge.replace(80, 4, "\xff\xff\xff\xff");
  EXPECT_EQ(complaint_about("a.stl", huge),
            "a.stl: has 684 bytes, expected 214748364834 for the 4294967295 facets of its binary STL header");
  EXPECT_EQ(complaint_about("a.stl", good.substr(0, 20)),
            "a.stl: ends after 20 bytes, expected a binary STL header of 84");
}

TEST(BadBinaryStl, HasACoordinateThatIsNotFinite) {
  std::string bytes = binary_stl(unit_box());
  bytes.replace(84 + 50 + 12, 4, bytes_of(std::numeric_limits<float>::quiet_NaN()));
  EXPECT_EQ(complaint_about("a.stl", bytes), "a.stl: facet 2 of 12: expected finite coordinates, found (nan, 0, 0)");
}

TEST(BadObj, NamesAVertexThatDoesNotExist) {
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_EQ(complaint_about("a.obj", three + "f 1 2 4\n"), "a.obj:4:7: vertex 4 does not exist, the file has 3");
  EXPECT_EQ(complaint_about("a.obj", three + "f 1 0 3\n"),
            "a.obj:4:5: vertex 0 does not exist, expected numbers from 1");
  EXPECT_EQ(complaint_about("a.obj", three + "f -1 -2 -4\n"), "a.obj:4:9: vertex -4 does not exist, the file has 3");
  EXPECT_EQ(complaint_about("a.obj", three + "f 1 2 three\n"), "a.obj:4:7: expected a vertex number, found 'three'");
  EXPECT_EQ(complaint_about("a.obj", three + "f 1 2 99999999999999999999\n"),
            "a.obj:4:7: expected a vertex number, found '99999999999999999999'");
}

TEST(BadObj, HasAFaceOfTooFewVertices) {
  EXPECT_EQ(complaint_about("a.obj", "v 0 0 0\nf 1 1\n"), "a.obj:2:6: expected at least 3 vertices, found 2");
  EXPECT_EQ(complaint_about("a.obj", "v 0 0 0\nf\n"), "a.obj:2:2: expected at least 3 vertices, found 0");
}

TEST(BadObj, HasAVertexOfTooFewCoordinates) {
  EXPECT_EQ(complaint_about("a.obj", "v 0 0 0\nv 1 2\n"),
            "a.obj:2:6: expected a coordinate, a finite number, found the end of the line");
}

const std::string ply_vertices = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string ply_faces = "element face 1\nproperty list uchar int vertex_indices\n";

std::string ply_of(const std::string& header, const std::string& rows) {
  return "ply\nformat ascii 1.0\n" + header + "end_header\n" + rows;
}

TEST(BadPly, HasAHeaderThatDescribesNoSurface) {
  EXPECT_EQ(complaint_about("a.ply", ply_of("", "")), "a.ply:3: the header has no element face, expected one");
  EXPECT_EQ(complaint_about("a.ply", ply_of(ply_faces + ply_vertices, "                                ")),
            "a.ply:3: element face comes before element vertex, expected it after");
  EXPECT_EQ(complaint_about("a.ply", ply_of("element vertex 1\nproperty float x\n" + ply_faces, "          ")),
            "a.ply:3: element vertex has 0 properties y, expected one");
  EXPECT_EQ(complaint_about("a.ply", ply_of(ply_vertices + "element face 1\nproperty int a\n", std::string(40, ' '))),
            "a.ply:7: element face has 0 integer lists vertex_indices, expected one");
}

TEST(BadPly, HasAHeaderThatIsBroken) {
  EXPECT_EQ(complaint_about("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n"),
            "a.ply:4:1: the header ends here, expected end_header");
  EXPECT_EQ(complaint_about("a.ply", "ply\nformat utf8 1.0\n"),
            "a.ply:2:8: expected ascii, binary_little_endian or binary_big_endian, found 'utf8'");
  EXPECT_EQ(complaint_about("a.ply", ply_of("element vertex many\n", "")),
            "a.ply:3:16: expected an integer, found 'many'");
  EXPECT_EQ(complaint_about("a.ply", ply_of("element vertex -3\n", "")),
            "a.ply:3:16: expected a number of rows, found -3");
  EXPECT_EQ(complaint_about("a.ply", ply_of("element vertex 3\nproperty real x\n", "")),
            "a.ply:4:10: expected a type: char uchar short ushort int uint float double, found 'real'");
}

TEST(BadPly, AnnouncesMoreThanTheFileHolds) {
  EXPECT_EQ(complaint_about("a.ply", ply_of("element vertex 4000000000\nproperty float x\nproperty float y\n"
                                            "property float z\n" +
                                                ply_faces,
                                            "0 0 0\n")),
            "a.ply:3: 4000000000 rows of element vertex do not fit into the 6 bytes after the header");
}

TEST(BadPly, HasRowsThatAreWrong) {
  const std::string header = ply_vertices + ply_faces;
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(complaint_about("a.ply", ply_of(header, vertices + "3 0 1 3\n")),
            "a.ply:13:7: vertex 3 does not exist, expected 0 to 2");
  EXPECT_EQ(complaint_about("a.ply", ply_of(header, vertices + "2 0 1\n")),
            "a.ply:13:1: expected a face of at least 3 vertices, found 2");
  EXPECT_EQ(complaint_about("a.ply", ply_of(header, "0 0 0\n1 0 0 5\n0 1 0\n3 0 1 2\n")),
            "a.ply:11:7: expected the end of the row, found '5'");
  EXPECT_EQ(complaint_about("a.ply", ply_of(header, "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n")),
            "a.ply:11:3: expected a finite number, found 'nan'");
  EXPECT_EQ(complaint_about("a.ply", ply_of(header, vertices)),
            "a.ply:13:1: the file ends here, expected row 1 of 1 of element face");
}

TEST(BadPly, HasFacesWhoseWordsAreWrong) {
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
  const auto complaint = [&](const std::string& properties, const std::string& row) {
    return complaint_about("a.ply", ply_of(ply_vertices + ply_faces + properties, vertices + row));
  };
  const std::string bytes = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  EXPECT_EQ(complaint(bytes, "3 0 1 2 0 256 0\n"), "a.ply:16:11: 256 is no value of its property's type");
  EXPECT_EQ(complaint("property char zone\n", "3 0 1 2 -129\n"), "a.ply:14:9: -129 is no value of its property's type");
  EXPECT_EQ(complaint("property char zone\n", "3 0 1 2 x\n"), "a.ply:14:9: expected an integer, found 'x'");
  EXPECT_EQ(complaint("property char zone\n", "3 0 1 2\n"),
            "a.ply:14:8: expected an integer, found the end of the line");
  EXPECT_EQ(complaint("property char zone\nproperty int zone\n", "3 0 1 2 3 4\n"),
            "a.ply:7: element face has a property zone twice, expected once");
}

TEST(BadPly, HasBinaryRowsThatAreWrong) {
  const std::string good = ply(unit_box(), "binary_big_endian");
  EXPECT_EQ(complaint_about("a.ply", good.substr(0, good.size() - 1)),
            "a.ply: row 12 of 12 of element face: the file ends here");
  std::string wrong = good;
  wrong.replace(good.size() - 4, 4, bytes_of(std::uint32_t{8}, true));
  EXPECT_EQ(complaint_about("a.ply", wrong),
            "a.ply: row 12 of 12 of element face: vertex 8 does not exist, expected 0 to 7");
}

TEST(BadOff, IsWrong) {
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(complaint_about("a.off", "OFF\n3 1 0\n" + vertices + "3 0 1 3\n"),
            "a.off:6:7: vertex 3 does not exist, expected 0 to 2");
  EXPECT_EQ(complaint_about("a.off", "OFF\n3 1 0\n" + vertices + "2 0 1\n"),
            "a.off:6:1: expected a face of at least 3 vertices, found 2");
  EXPECT_EQ(complaint_about("a.off", "OFF\n3 1 0\n" + vertices),
            "a.off:6:1: expected face 1 of 1, found the end of the file");
  EXPECT_EQ(complaint_about("a.off", "OFF\n3000000000 1 0\n" + vertices),
            "a.off:2:1: 3000000000 vertices do not fit into the 23 bytes that follow");
  EXPECT_EQ(complaint_about("a.off", "4OFF\n3 1 0\n" + vertices),
            "a.off:1:1: '4OFF' has more than 3 dimensions, expected OFF, COFF, NOFF or STOFF");
  EXPECT_EQ(complaint_about("a.off", "OFF BINARY\n"), "a.off:1:1: binary OFF is not read, expected OFF as text");
  EXPECT_EQ(complaint_about("a.off", "OFF\n"),
            "a.off:2:1: expected the numbers of vertices and faces, found the end of the file");
}

TEST(BadOff, HasNumbersThatAreNone) {
  EXPECT_EQ(complaint_about("a.off", "OFF\n3 1 0\n0 0 0\n1 0,5 0 1\n0 1 0\n3 0 1 2\n"),
            "a.off:4:3: expected a coordinate, a finite number, found '0,5'");
  EXPECT_EQ(complaint_about("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1.7 2\n"),
            "a.off:6:5: expected an integer, found '1.7'");
  EXPECT_EQ(complaint_about("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n100000000 0 1 2\n"),
            "a.off:6:16: expected an integer, found the end of the line");
}

TEST(BadFile, IsNeverMoreThanAnInputErrorWhateverBytesAreChangedOrCutOff) {
  std::mt19937_64 random(20);
  const Folder folder;
  int refused = 0;
  for (const std::string& good : every_format(unit_box())) {
    for (int k = 0; k < 150; ++k) {
      std::string bytes = good.substr(0, k % 3 == 0 ? random() % good.size() : good.size());
      for (std::size_t flips = random() % 6; flips > 0 && !bytes.empty(); --flips)
        bytes[random() % bytes.size()] = static_cast<char>(random());
      try {
        const FacetMesh mesh = read_mesh(folder.write("a.stl", bytes));
        EXPECT_GT(mesh.size(), 0U);
        for (const Vec3& p : mesh.positions) EXPECT_TRUE(p.allFinite());
      } catch (const InputError& error) {
        EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos);
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 300);
}

}  // namespace
}  // namespace lrcs
