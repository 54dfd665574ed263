#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <limits>

#include "made_round_meshes.h"
#include "mesh/ply_blocks.h"
#include "mesh/repair.h"
#include "mesh_files.h"

namespace lrcs {
namespace {

// How a binary PLY lays out its rows. A list more in each row makes rows that are read one by one.
struct Layout {
  const char *number, *count, *index;
  bool big_endian, more_scalars, list_in_vertices, list_in_faces;
};

std::string bytes_of_whole(std::uint32_t x, const std::string& type, bool big) {
  if (type.find("char") != type.npos || type.ends_with("int8")) return bytes_of(static_cast<std::uint8_t>(x), big);
  if (type.find("short") != type.npos || type.ends_with("int16")) return bytes_of(static_cast<std::uint16_t>(x), big);
  return bytes_of(x, big);
}

std::string bytes_of_number(double x, const std::string& type, bool big) {
  if (type == "float" || type == "float32") return bytes_of(static_cast<float>(x), big);
  if (type == "double" || type == "float64") return bytes_of(x, big);
  return bytes_of_whole(static_cast<std::uint32_t>(static_cast<std::int32_t>(x)), type, big);
}

std::string ply_of(const FacetMesh& mesh, const Layout& l) {
  const std::string more = std::string("property uchar flag\nproperty double weight\n");
  std::string file = fmt::format("ply\nformat binary_{}_endian 1.0\nelement vertex {}\n",
                                 l.big_endian ? "big" : "little", mesh.positions.size());
  if (l.more_scalars) file += more;
  for (const char* axis : {"z", "x", "y"}) file += fmt::format("property {} {}\n", l.number, axis);
  if (l.list_in_vertices) file += "property list uchar int near\n";
  file += fmt::format("element face {}\nproperty list {} {} vertex_indices\n", mesh.size(), l.count, l.index);
  if (l.list_in_faces) file += "property list uchar int near\n";
  file += "end_header\n";
  for (const Vec3& p : mesh.positions) {
    if (l.more_scalars) file += '\x01' + bytes_of(0.5, l.big_endian);
    for (const double x : {p.z(), p.x(), p.y()}) file += bytes_of_number(x, l.number, l.big_endian);
    if (l.list_in_vertices) file += '\x01' + bytes_of(7, l.big_endian);
  }
  for (const auto& facet : mesh.facets) {
    file += bytes_of_whole(3, l.count, l.big_endian);
    for (const std::uint32_t corner : facet) file += bytes_of_whole(corner, l.index, l.big_endian);
    if (l.list_in_faces) file += '\0';
  }
  return file;
}

// A ball of some thousand facets, coordinates whole numbers.
FacetMesh ball(int levels = 5) {
  FacetMesh mesh = jittered_ball(levels, 0.1, 3);
  for (Vec3& p : mesh.positions) p = (10000.0 * p).array().round();
  return mesh;
}

void expect_same_bytes(const FacetMesh& a, const FacetMesh& b) {
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.facets, b.facets);
  EXPECT_EQ(a.source_facet, b.source_facet);
  EXPECT_EQ(a.part.of, b.part.of);
  EXPECT_EQ(a.file_material.of, b.file_material.of);
  EXPECT_EQ(a.normals, b.normals);
  EXPECT_EQ(a.areas, b.areas);
}

TEST(ReadPly, GivesTheSameAtOnceAsRowByRow) {
  const FacetMesh mesh = ball(3);
  for (const char* number : {"float", "double", "short"})
    for (const char* count : {"uchar", "int", "ushort"})
      for (const char* index : {"int", "uint", "ushort"})
        for (const bool big : {false, true})
          for (const bool more : {false, true}) {
            const FacetMesh at_once =
                mesh_of_file("a.ply", ply_of(mesh, {number, count, index, big, more, false, false}));
            EXPECT_EQ(at_once.facets, mesh.facets);
            EXPECT_EQ(at_once.positions, mesh.positions);
            expect_same_bytes(mesh_of_file("a.ply", ply_of(mesh, {number, count, index, big, more, true, false})),
                              at_once);
            expect_same_bytes(mesh_of_file("a.ply", ply_of(mesh, {number, count, index, big, more, false, true})),
                              at_once);
          }
}

TEST(ReadPly, TakesEveryTypeOfNumber) {
  FacetMesh mesh = ball(1);
  for (Vec3& p : mesh.positions) p = (0.005 * p).array().round() + 60.0;
  ASSERT_LT(mesh.positions.size(), 128U);
  const std::vector<const char*> whole{"char", "uchar", "short", "ushort", "int",   "uint",
                                       "int8", "uint8", "int16", "uint16", "int32", "uint32"};
  std::vector<const char*> any = whole;
  any.insert(any.end(), {"float", "double", "float32", "float64"});
  for (std::size_t k = 0; k < any.size(); ++k)
    for (const bool big : {false, true})
      for (const bool row_by_row : {false, true}) {
        const char *count = whole[k % whole.size()], *index = whole[(5 * k + 1) % whole.size()];
        const FacetMesh read =
            mesh_of_file("a.ply", ply_of(mesh, {any[k], count, index, big, false, row_by_row, row_by_row}));
        EXPECT_EQ(read.positions, mesh.positions) << any[k];
        EXPECT_EQ(read.facets, mesh.facets) << count << " " << index;
      }
}

TEST(PlyBlocks, TakeRowsOfOneSizeAndLeaveAllElseAlone) {
  const FacetMesh mesh = ball(2);
  for (const bool list_in_vertices : {false, true})
    for (const bool list_in_faces : {false, true}) {
      const std::string file = ply_of(mesh, {"float", "uchar", "int", false, true, list_in_vertices, list_in_faces});
      const PlyHeader header = read_ply_header(file, "a.ply");
      BinaryPlyRows rows(std::string_view(file).substr(header.data_begin), false, "a.ply");
      const std::size_t all = rows.bytes().size(), faces = mesh.size() * (13 + (list_in_faces ? 1 : 0));
      MeshBuilder builder;
      EXPECT_EQ(read_block(rows, header.elements[0], builder), !list_in_vertices);
      EXPECT_EQ(rows.bytes().size(), list_in_vertices ? all : faces);
      EXPECT_EQ(builder.position_count(), list_in_vertices ? 0 : mesh.positions.size());
      if (list_in_vertices) continue;
      EXPECT_EQ(read_block(rows, header.elements[1], builder), !list_in_faces);
      EXPECT_EQ(rows.bytes().size(), list_in_faces ? faces : 0);
      EXPECT_EQ(builder.finish().size(), list_in_faces ? 0 : mesh.size());
    }
}

TEST(ReadPly, NamesTheFirstWrongRowOfThousands) {
  const FacetMesh good = ball();
  FacetMesh mesh = good;
  for (const std::size_t facet : {15000, 9000, 20000}) mesh.facets[facet][1] = 1000000;
  const Layout usual{"float", "uchar", "int", false, false, false, false};
  EXPECT_EQ(complaint_about("a.ply", ply_of(mesh, usual)),
            fmt::format("a.ply: row 9001 of {} of element face: vertex 1000000 does not exist, expected 0 to {}",
                        mesh.size(), mesh.positions.size() - 1));
  mesh = good;
  mesh.positions[9000].x() = mesh.positions[8000].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(complaint_about("a.ply", ply_of(mesh, usual)),
              testing::StartsWith(fmt::format("a.ply: row 8001 of {} of element vertex", mesh.positions.size())));
  const std::string whole = ply_of(good, usual);
  EXPECT_EQ(complaint_about("a.ply", whole.substr(0, whole.size() - 14)),
            fmt::format("a.ply: row {} of {} of element face: the file ends here", good.size() - 1, good.size()));
}

TEST(ReadPly, TakesAPolygonAmongThousandsOfTriangles) {
  const FacetMesh mesh = ball();
  std::string file = ply_of(mesh, {"float", "uchar", "int", false, false, false, false});
  const std::string faces = fmt::format("element face {}", mesh.size());
  file.replace(file.find(faces), faces.size(), fmt::format("element face {}", mesh.size() + 1));
  file += '\x04';
  for (const std::uint32_t corner : {mesh.facets[0][0], mesh.facets[0][1], mesh.facets[0][2], mesh.facets[1][0]})
    file += bytes_of(corner);
  EXPECT_EQ(mesh_of_file("a.ply", file).size(), mesh.size() + 2);
}

TEST(ReadMesh, AndRepairGiveTheSameBytesOnAnyNumberOfThreads) {
  const FacetMesh mesh = ball();
  for (const std::string& file : every_format(mesh)) {
    std::vector<FacetMesh> made;
    for (const std::size_t threads : {1, 2, 5}) {
      const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, threads);
      made.push_back(mesh_of_file("a", file));
      repair(made.back());
      expect_same_bytes(made.back(), made.front());
    }
  }
}

}  // namespace
}  // namespace lrcs
