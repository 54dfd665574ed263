#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "base/input_error.h"
#include "cad/read_target.h"
#include "mesh/diagnosis.h"
#include "tests/scratch_folder.h"

namespace lrcs {
namespace {

using testing::ElementsAre;

// A unit square as two triangles, a unit square as a quadrilateral and one as a strip, each at its own height; one
// line.
const std::string squares = R"(<?xml version="1.0"?>
<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData>
<Piece NumberOfPoints="12" NumberOfVerts="0" NumberOfLines="1" NumberOfStrips="1" NumberOfPolys="3">
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
0 0 0 1 0 0 1 1 0 0 1 0  0 0 1 1 0 1 1 1 1 0 1 1  0 0 2 1 0 2 0 1 2 1 1 2.125</DataArray></Points>
<Lines><DataArray type="Int32" Name="connectivity" format="ascii">0 1</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">2</DataArray></Lines>
<Polys><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2 0 2 3 4 5 6 7</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">3 6 10</DataArray></Polys>
<Strips><DataArray type="Int32" Name="connectivity" format="ascii">8 9 10 11</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">4</DataArray></Strips>
<CellData><DataArray type="Int32" Name="coating" format="ascii">9 1 2 1 3</DataArray>
<DataArray type="Float32" Name="temperature" format="ascii">0 1 2 3 4</DataArray></CellData>
</Piece></PolyData></VTKFile>
)";

class ReadVtk : public testing::Test {
 protected:
  [[nodiscard]] TargetRead read(const std::string& content) const {
    folder_.write("made.vtp", content);
    return read_target(folder_.path() / "made.vtp", "mm");
  }
  ScratchFolder folder_;
};

TEST_F(ReadVtk, ReadsPolygonsStripsAndCellArrays) {
  const TargetRead target = read(squares);
  EXPECT_EQ(target.unit, "mm");
  EXPECT_EQ(target.mesh.size(), 6U);
  ASSERT_EQ(target.mesh.properties.size(), 1U);
  EXPECT_EQ(target.mesh.properties[0].name, "coating");
  EXPECT_THAT(target.mesh.properties[0].values.names, ElementsAre("1", "2", "3"));
  EXPECT_THAT(target.mesh.properties[0].values.of, ElementsAre(0, 1, 0, 0, 2, 2));
  EXPECT_EQ(target.mesh.positions[11], Vec3(1.0, 1.0, 2.125));
  for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(target.mesh.normals[k], Vec3(0.0, 0.0, 1.0)) << k;
  EXPECT_GT(target.mesh.normals[5].z(), 0.0);
}

TEST_F(ReadVtk, RefusesAPointThatIsNotThere) {
  std::string wrong = squares;
  wrong.replace(wrong.find("4 5 6 7</DataArray>"), 7, "4 5 6 99");
  EXPECT_THROW((void)read(wrong), InputError);
}

TEST_F(ReadVtk, IsAnInputErrorWhateverBytesAreChangedOrCutOff) {
  std::mt19937_64 random(7);
  int refused = 0;
  for (int k = 0; k < 40; ++k) {
    std::string bytes = squares.substr(0, k % 4 == 0 ? random() % squares.size() : squares.size());
    for (std::size_t flips = 1 + random() % 6; flips > 0 && !bytes.empty(); --flips)
      bytes[random() % bytes.size()] = static_cast<char>(32 + random() % 95);
    try {
      EXPECT_GT(read(bytes).mesh.size(), 0U);
    } catch (const InputError& error) {
      EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(refused, 5);
}

}  // namespace
}  // namespace lrcs
