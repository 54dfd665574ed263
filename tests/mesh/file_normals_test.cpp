#include "mesh/file_normals.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/normal_patches.h"
#include "mesh/repair.h"
#include "normal_files.h"
#include "tests/mutations.h"

namespace lrcs {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Curved {
  FacetMesh mesh;
  std::vector<std::string> warnings;
};

Curved curved_by_file(const Folder& folder, const std::string& name, const std::string& content) {
  Curved curved;
  FileNormals normals;
  const auto file = folder.write(name, content);
  curved.mesh = read_mesh(file, &curved.warnings, &normals);
  normals.curve(curved.mesh, name, curved.warnings);
  return curved;
}

Curved curved_by_file(const std::string& name, const std::string& content) {
  return curved_by_file(Folder(), name, content);
}

std::string complaint_about_normals(const std::string& name, const std::string& content) {
  const Folder folder;
  try {
    (void)curved_by_file(folder, name, content);
    return "";
  } catch (const InputError& wrong) {
    const std::string text = wrong.what(), path = folder.path().string() + "/";
    return text.starts_with(path) ? text.substr(path.size()) : text;
  }
}

void expect_same_patches(const FacetMesh& a, const FacetMesh& b, const std::string& what) {
  ASSERT_EQ(a.curved.of, b.curved.of) << what;
  for (std::size_t k = 0; k < a.curved.patches.size(); ++k)
    for (std::size_t p = 0; p < PatchRule::size; ++p) {
      EXPECT_LT((a.curved.patches[k].normal[p] - b.curved.patches[k].normal[p]).norm(), 1e-14) << what;
      EXPECT_NEAR(a.curved.patches[k].area[p] / b.curved.patches[k].area[p], 1.0, 1e-13) << what;
    }
}

TEST(FileNormals, AreThoseOfTheCornersInEveryFormat) {
  CornerMesh tube = cylinder_with_normals(12, 2.0);
  round_to_floats(tube);
  const VertexMesh own = unwelded(tube);
  FacetMesh expected = tube.mesh;
  CornerNormals unit = tube.normals;
  for (auto& corners : unit)
    for (Vec3& n : corners) n.normalize();
  EXPECT_THAT(curve_by_normals(expected, unit), IsEmpty());
  EXPECT_EQ(expected.curved.patches.size(), 24U);  // the caps are flat
  for (const auto& [name, content] : {std::pair<std::string, std::string>{"a.obj", obj(tube)},
                                      {"a.off", noff(own)},
                                      {"text.ply", ply(own, "ascii")},
                                      {"little.ply", ply(own, "binary_little_endian")},
                                      {"big.ply", ply(own, "binary_big_endian")}}) {
    const Curved read = curved_by_file(name, content);
    EXPECT_THAT(read.warnings, IsEmpty()) << name;
    expect_same_patches(read.mesh, expected, name);
  }
}

TEST(FileNormals, AreNotLookedAtUnlessAskedFor) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 nan\n";
  EXPECT_TRUE(mesh_of_file("a.obj", vertices + "f 1//1 2//7 3\n").curved.of.empty());
}

// Two facets of a quadrilateral that is not flat, and normals of lengths other than 1.
const std::string fold = "v 0 0 0\nv 1 0 0\nv 1 1 0.1\nv 0 1 0\nvn 0.1 0 1\nvn 0 0.2 2\nvn 0 0 3\nvn 0 0.1 1\n";

TEST(FileNormals, AreFoundHoweverAnObjNamesThem) {
  const Curved plain = curved_by_file("a.obj", fold + "f 1//1 2//2 3//3 4//4\n");
  EXPECT_EQ(plain.mesh.curved.patches.size(), 2U);
  for (const char* face : {"vt 0 0\nf 1/1/1 2/1/2 3/1/3 4/1/4\n", "f -4//-4 -3//-3 -2//-2 -1//-1\n",
                           "vn 1 0 0\nf -4//-5 -3//-4 -2//-3 -1//-2\n", "f 1//1 2//2 3//3 -1//4 # last\n"})
    expect_same_patches(curved_by_file("a.obj", fold + face).mesh, plain.mesh, face);
  // The face comes first, and its numbers count from the front.
  expect_same_patches(curved_by_file("a.obj", "f 1//1 2//2 3//3 4//4\n" + fold).mesh, plain.mesh, "face first");
}

TEST(FileNormals, FollowTheCornersOfAPolygonThatIsCut) {
  // An L, which is cut by a Delaunay triangulation.
  const std::string corners = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\n";
  std::string normals, face = "f";
  for (int k = 1; k <= 6; ++k) {
    normals += fmt::format("vn 0 {} 1\n", 0.05 * k);
    face += fmt::format(" {}//{}", k, k);
  }
  const Curved read = curved_by_file("a.obj", corners + normals + face + "\n");
  ASSERT_EQ(read.mesh.size(), 4U);
  FacetMesh expected = read.mesh;
  expected.curved = {};
  CornerNormals of_corners(4);
  for (std::size_t f = 0; f < 4; ++f)
    for (std::size_t k = 0; k < 3; ++k)
      of_corners[f][k] = Vec3(0.0, 0.05 * (expected.facets[f][k] + 1), 1.0).normalized();
  EXPECT_THAT(curve_by_normals(expected, of_corners), IsEmpty());
  expect_same_patches(read.mesh, expected, "L");
}

TEST(FileNormals, StayInStepWithFacetsThatRepairTurnsAndDrops) {
  const CornerMesh ball = ball_with_normals(1, 0.1);
  FacetMesh clean = curved_by_file("a.obj", obj(ball)).mesh;
  repair(clean);
  CornerMesh dirty = ball;
  dirty.mesh.facets.clear();
  dirty.normals.clear();
  const auto add = [&](std::array<std::uint32_t, 3> facet, std::array<Vec3, 3> normals) {
    dirty.mesh.facets.push_back(facet);
    dirty.normals.push_back(normals);
  };
  for (std::size_t k = 0; k < ball.mesh.size(); ++k) {
    auto facet = ball.mesh.facets[k];
    auto normals = ball.normals[k];
    if (k % 3 == 1) {
      std::swap(facet[1], facet[2]);
      std::swap(normals[1], normals[2]);
    }
    add(facet, normals);
    if (k % 5 == 1) add(facet, normals);
    if (k % 7 == 1) add({facet[0], facet[0], facet[1]}, {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()});
  }
  Curved read = curved_by_file("a.obj", obj(dirty));
  EXPECT_EQ(read.warnings.size(), 1U);
  const RepairCounts repaired = repair(read.mesh);
  EXPECT_EQ(repaired.flipped, 27U);
  EXPECT_EQ(repaired.duplicate, 16U);
  EXPECT_EQ(repaired.degenerate, 12U);
  ASSERT_EQ(read.mesh.size(), clean.size());
  // Turned facets begin at the same corner.
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < clean.size(); ++k) {
    const CurvedPatch &a = read.mesh.curved.patches[read.mesh.curved.of[k]],
                      &b = clean.curved.patches[clean.curved.of[k]];
    for (std::size_t p = 0; p < PatchRule::size; ++p) {
      EXPECT_LT((a.normal[p] - b.normal[p]).norm(), 1e-14) << k;
      sum += patch_rule().weight[p] * a.area[p] * a.normal[p];
    }
  }
  EXPECT_LT(sum.norm(), 1e-14);
}

TEST(FileNormals, LeaveTheFrontToTheWinding) {
  const Curved with = curved_by_file("a.obj", fold + "f 1//1 2//2 3//3\n");
  const std::string against = "v 0 0 0\nv 1 0 0\nv 1 1 0.1\nv 0 1 0\nvn -0.1 0 -1\nvn 0 -0.2 -2\nvn 0 0 -3\n";
  const Curved read = curved_by_file("a.obj", against + "f 1//1 2//2 3//3\n");
  EXPECT_THAT(read.warnings,
              ElementsAre("1 of 1 facets are wound against their normals, first face 0 as read (from 0): which "
                          "side is the front is told by the winding, the normals only bend"));
  expect_same_patches(read.mesh, with.mesh, "against");
}

TEST(FileNormals, LeaveFacetsFlatThatTheyAreTooFarOff) {
  const Curved read = curved_by_file("a.obj", fold + "vn 2 0 1\nf 1//1 2//2 3//3\nf 1//1 3//5 4//4\n");
  EXPECT_THAT(read.warnings, ElementsAre("1 facets stay flat: a normal in the file is more than 60 deg off them, "
                                         "first face 1 as read (from 0)"));
  EXPECT_THAT(read.mesh.curved.of, ElementsAre(0U, CurvedFacets::flat));
  // Some to the front and some to the back.
  EXPECT_EQ(curved_by_file("a.obj", fold + "vn 0 0 -1\nf 1//1 2//2 3//3\nf 1//1 3//5 4//4\n").mesh.curved.of,
            read.mesh.curved.of);
}

TEST(FileNormals, SayThatTheyBendNoFacet) {
  const Curved read = curved_by_file("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n");
  EXPECT_THAT(read.warnings,
              ElementsAre("file_normals bends no facet: where the normals are of use, they are the facets' own"));
  EXPECT_TRUE(read.mesh.curved.of.empty());
}

TEST(FileNormals, WithoutALengthMatterOnlyWhereAFacetHasThem) {
  const std::string zero = "vn 0 0 0\n";
  EXPECT_EQ(complaint_about_normals("a.obj", fold + zero + "f 1//1 2//2 3//3\n"), "");
  EXPECT_EQ(complaint_about_normals("a.obj", fold + zero + "f 1//5 1//5 2//5\nf 1//1 2//2 3//3\n"), "");
  EXPECT_EQ(complaint_about_normals("a.obj", fold + zero + "f 1//1 2//2 3//3\nf 1//1 3//5 4//4\n"),
            "a.obj:9: normal 4 as read (from 0), which its face 1 has, is (0, 0, 0), expected a length above 0");
}

struct BadFile {
  const char* name;
  std::string content, complaint;
};

TEST(FileNormals, ThatAreMissingOrWrongAreAnErrorWithItsPlace) {
  const std::string no_normals = "has no normals at its vertices, expected them for curved: file_normals";
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\n";
  const std::string ply_head = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n";
  const std::string ply_tail = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const std::string normal_properties = "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n";
  const CornerMesh ball = ball_with_normals(0, 0.0);
  VertexMesh nan = unwelded(ball);
  nan.normals[4] = Vec3(0.0, NAN, 0.0);
  const std::vector<BadFile> files{
      {"a.stl", text_stl(ball.mesh), "a.stl: " + no_normals},
      {"a.stl", binary_stl(ball.mesh), "a.stl: " + no_normals},
      {"a.off", off(ball.mesh), "a.off: " + no_normals},
      {"a.off", "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0\n0 1 0 0 0 1\n3 0 1 2\n",
       "a.off:4:10: expected a component of a normal, a finite number, found the end of the line"},
      {"a.obj", obj(ball.mesh), "a.obj:14:3: expected a vertex with its normal, v//vn or v/vt/vn, found '1'"},
      {"a.obj", triangle + "f 1//1 2//1 3/1\n",
       "a.obj:5:13: expected a vertex with its normal, v//vn or v/vt/vn, found '3/1'"},
      {"a.obj", triangle + "f 1//1 2//1 3/1/1/1\n",
       "a.obj:5:13: expected a vertex with its normal, v//vn or v/vt/vn, found '3/1/1/1'"},
      {"a.obj", triangle + "f 1//1 2//1 3/1/\n",
       "a.obj:5:13: expected a vertex with its normal, v//vn or v/vt/vn, found '3/1/'"},
      {"a.obj", triangle + "f 1//1 2//1 3//2\n", "a.obj:5:13: normal 2 does not exist, the file has 1"},
      {"a.obj", triangle + "f 1//1 2//1 3//0\n", "a.obj:5:13: normal 0 does not exist, expected numbers from 1"},
      {"a.obj", triangle + "f 1//1 2//1 3//-2\n", "a.obj:5:13: normal -2 does not exist, the file has 1"},
      {"a.obj", triangle + "f 1//1 2//1 3//x\n", "a.obj:5:13: expected a normal number, found 'x'"},
      {"a.obj", triangle + "vn 0 0\nf 1//1 2//1 3//1\n",
       "a.obj:5:7: expected a component of a normal, a finite number, found the end of the line"},
      {"a.obj", triangle + "vn 0 nan 0\nf 1//1 2//1 3//1\n",
       "a.obj:5:6: expected a component of a normal, a finite number, found 'nan'"},
      {"a.obj", triangle + "v 1 1 0\nvn 0 0.1 1\nf 1//1 2//1 1//2 3//1\n",
       "a.obj:7:22: the face passes a vertex twice with two normals, expected one normal there"},
      {"a.ply", ply(ball.mesh, "ascii"),
       "a.ply:3: element vertex has 0 properties nx, expected one for curved: file_normals"},
      {"a.ply", ply(ball.mesh, "binary_big_endian"),
       "a.ply:3: element vertex has 0 properties nx, expected one for curved: file_normals"},
      {"a.ply", ply_head + normal_properties + ply_tail + "0 0 0 0 0 1\n1 0 0 0 inf 1\n0 1 0 0 0 1\n3 0 1 2\n",
       "a.ply:14:9: expected a finite number, found 'inf'"},
      {"a.ply", ply_head + normal_properties + ply_tail + "0 0 0 0 0 1\n1 0 0 0 0 0\n0 1 0 0 0 1\n3 0 1 2\n",
       "a.ply:14: normal 1 as read (from 0), which its face 0 has, is (0, 0, 0), expected a length above 0"},
      {"a.ply", ply(nan, "binary_little_endian"),
       "a.ply: normal 4 as read (from 0), which its face 1 has, is (0, nan, 0), expected a length above 0"}};
  for (const BadFile& bad : files) EXPECT_EQ(complaint_about_normals(bad.name, bad.content), bad.complaint);
}

TEST(FileNormals, OfDamagedFilesMakePatchesOrAnInputError) {
  const CornerMesh tube = cylinder_with_normals(8, 2.0);
  const VertexMesh own = unwelded(tube);
  const std::vector<std::pair<std::string, std::string>> good{{"a.obj", obj(tube)},
                                                              {"a.off", noff(own)},
                                                              {"text.ply", ply(own, "ascii")},
                                                              {"big.ply", ply(own, "binary_big_endian")}};
  const Folder folder;
  Mutations mutations(11);
  int refused = 0;
  for (int k = 0; k < 2000; ++k) {
    const auto& [name, content] = good[static_cast<std::size_t>(k) % good.size()];
    try {
      const Curved read = curved_by_file(folder, name, mutations.of(content, good[0].second));
      for (const CurvedPatch& patch : read.mesh.curved.patches)
        for (std::size_t p = 0; p < PatchRule::size; ++p)
          EXPECT_TRUE(std::isfinite(patch.area[p]) && std::abs(patch.normal[p].norm() - 1.0) < 1e-12) << k;
    } catch (const InputError& wrong) {
      EXPECT_EQ(std::string_view(wrong.what()).find('\n'), std::string_view::npos) << wrong.what();
      ++refused;
    }
  }
  EXPECT_GT(refused, 1000);
  EXPECT_LT(refused, 1950);
}

}  // namespace
}  // namespace lrcs
