#include "mesh/write_mesh.h"

#include <gtest/gtest.h>

#include "made_meshes.h"
#include "tests/scratch_folder.h"

namespace lrcs {
namespace {

// Two parts of two materials each, with coordinates of all digits.
FacetMesh named_boxes() {
  FacetMesh mesh = joined(box({0.1, 1.0 / 3.0, -1e-17}, {1e9 / 7.0, 2, 3}), unit_box(), true);
  mesh.part.names = {"body", "boom:2"};
  mesh.file_material.names = {"paint", "gold"};
  for (std::size_t k = 0; k < mesh.size(); ++k) mesh.file_material.of[k] = k % 5 < 2 ? 1 : 0;
  return mesh;
}

FacetMesh written_and_read(const std::string& name, const FacetMesh& mesh) {
  const ScratchFolder folder;
  write_mesh(folder.path() / name, mesh);
  return read_mesh(folder.path() / name);
}

TEST(WriteMesh, WritesWhatIsReadBackToTheSameFacets) {
  const FacetMesh mesh = named_boxes();
  for (const char* name : {"a.obj", "b.ply", "c.OFF"}) {
    const FacetMesh read = written_and_read(name, mesh);
    ASSERT_EQ(read.size(), mesh.size()) << name;
    for (std::size_t k = 0; k < mesh.size(); ++k) EXPECT_EQ(read.corners(k), mesh.corners(k)) << name << " " << k;
  }
}

TEST(WriteMesh, KeepsPartsAndMaterialsInObj) {
  const FacetMesh mesh = named_boxes();
  const FacetMesh read = written_and_read("a.obj", mesh);
  for (std::size_t k = 0; k < mesh.size(); ++k) {
    EXPECT_EQ(read.part.names[read.part.of[k]], mesh.part.names[mesh.part.of[k]]);
    EXPECT_EQ(read.file_material.names[read.file_material.of[k]], mesh.file_material.names[mesh.file_material.of[k]]);
  }
}

TEST(WriteMesh, RoundsStlToSinglePrecisionAndGivesItsNormals) {
  const FacetMesh mesh = named_boxes();
  const FacetMesh read = written_and_read("a.stl", mesh);
  ASSERT_EQ(read.size(), mesh.size());
  EXPECT_EQ(read.normals_against, 0U);
  FacetMesh against = mesh;
  for (std::size_t k = 0; k < 5; ++k) against.normals[k] *= -1.0;
  EXPECT_EQ(written_and_read("b.stl", against).normals_against, 5U);
  for (std::size_t k = 0; k < mesh.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c)
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_EQ(read.corners(k)[c][axis], static_cast<double>(static_cast<float>(mesh.corners(k)[c][axis])));
}

TEST(WriteMesh, KnowsItsFormatsByTheirExtensions) {
  EXPECT_TRUE(writes_mesh("x.Stl"));
  EXPECT_FALSE(writes_mesh("x.step"));
  EXPECT_FALSE(writes_mesh("x"));
  EXPECT_THROW(write_mesh("x.step", unit_box()), InputError);
  EXPECT_THROW(write_mesh("/nowhere/x.stl", unit_box()), std::runtime_error);
}

}  // namespace
}  // namespace lrcs
