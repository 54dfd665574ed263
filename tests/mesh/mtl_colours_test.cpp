#include "mesh/mtl_colours.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "mesh/read_mesh.h"
#include "tests/base/gzip.h"
#include "tests/scratch_folder.h"

namespace lrcs {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class ObjWithLibrary : public testing::Test {
 protected:
  // Facets of no material, red, tail fin and red.
  [[nodiscard]] FacetMesh read(const std::string& statement) {
    folder_.write("a.obj", statement +
                               "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nusemtl red\nf 1 2 3\nusemtl tail fin\nf 1 2 3\n"
                               "usemtl red\nf 3 2 1\n");
    warnings_.clear();
    return read_mesh(folder_.path() / "a.obj", &warnings_);
  }
  // The only warning, from after the folder's name.
  [[nodiscard]] std::string warning_of(const std::string& library) {
    folder_.write("a.mtl", library);
    EXPECT_THAT(read("mtllib a.mtl").colour.of, IsEmpty());
    EXPECT_EQ(warnings_.size(), 1U);
    return warnings_.empty() ? "" : warnings_[0].substr(folder_.path().string().size() + 1);
  }

  ScratchFolder folder_;
  std::vector<std::string> warnings_;
};

TEST_F(ObjWithLibrary, HasTheDiffuseColoursOfItsMaterials) {
  folder_.write("a.mtl",
                "# made\nnewmtl red\n\tKa 0 1 0\n\tKd 1 0 0.2 # bright\n\tmap_Kd red.png\nnewmtl tail fin\r\nKd 0.5\n"
                "newmtl dark\nNs 3\n");
  const FacetMesh mesh = read("mtllib a.mtl");
  EXPECT_THAT(mesh.colour.names, ElementsAre("", "#ff0033", "#808080"));
  EXPECT_THAT(mesh.colour.of, ElementsAre(0, 1, 2, 1));
  EXPECT_THAT(mesh.file_material.names, ElementsAre("", "red", "tail fin"));
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(ObjWithLibrary, TakesSeveralOfThemAndNamesWithBlanks) {
  folder_.write("my paint.mtl", gzip("newmtl red\nKd 1 0 0\n"));
  folder_.write("b.mtl", "newmtl tail fin\nKd 0 0 1\n");
  for (const std::string statement :
       {"mtllib b.mtl b.mtl\nmtllib my paint.mtl\nmtllib b.mtl", "mtllib my paint.mtl\nmtllib b.mtl"})
    EXPECT_THAT(read(statement).colour.names, ElementsAre("", "#ff0000", "#0000ff")) << statement;
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(ObjWithLibrary, HasNoColourWhereTheLibraryGivesASpectrumOrNone) {
  folder_.write("a.mtl", "newmtl red\nKd spectral red.rfl 1\nnewmtl tail fin\nKd xyz 0.1 0.2 0.3\n");
  EXPECT_THAT(read("mtllib a.mtl").colour.of, IsEmpty());
  EXPECT_THAT(read("").colour.of, IsEmpty());
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(ObjWithLibrary, IsReadWithAWarningWhereTheLibraryIsMissing) {
  EXPECT_EQ(read("mtllib none.mtl\nmtllib none.mtl").size(), 4U);
  EXPECT_THAT(warnings_, ElementsAre((folder_.path() / "none.mtl").string() +
                                     ": cannot be read: No such file or directory; its materials have no colours"));
  EXPECT_EQ(read("mtllib .").size(), 4U);
  EXPECT_THAT(warnings_, ElementsAre(testing::HasSubstr("is a folder, expected a file; its materials")));
}

TEST_F(ObjWithLibrary, SaysWhereTheLibraryIsBrokenAndTakesNothingOfIt) {
  const std::string tail = "; its materials have no colours";
  EXPECT_EQ(warning_of("newmtl red\nKd 1 0 0\nnewmtl x\nKd 1 green 0\n"),
            "a.mtl:4:6: expected a part of a colour, 0 to 1, found 'green'" + tail);
  EXPECT_EQ(warning_of("newmtl red\n  Kd 1 0 1.5\n"),
            "a.mtl:2:10: expected a part of a colour, 0 to 1, found '1.5'" + tail);
  EXPECT_EQ(warning_of("newmtl red\nKd 1 nan 0\n"),
            "a.mtl:2:6: expected a part of a colour, 0 to 1, found 'nan'" + tail);
  EXPECT_EQ(warning_of("newmtl red\nKd 1 0\n"),
            "a.mtl:2:7: expected a part of a colour, 0 to 1, found the end of the line" + tail);
  EXPECT_EQ(warning_of("newmtl red\nKd\n"),
            "a.mtl:2:3: expected a part of a colour, 0 to 1, found the end of the line" + tail);
  EXPECT_EQ(warning_of("Kd 1 0 0\n"), "a.mtl:1:1: expected newmtl before Kd" + tail);
}

TEST_F(ObjWithLibrary, IsReadWhateverBytesOfTheLibraryAreChanged) {
  std::mt19937_64 random(22);
  const std::string good = "newmtl red\nKd 1 0 0.5\nnewmtl tail fin\nKd 0.25\n";
  std::size_t warned = 0;
  for (int k = 0; k < 300; ++k) {
    std::string bytes = good;
    for (std::size_t flips = 1 + random() % 4; flips > 0; --flips)
      bytes[random() % bytes.size()] = k % 2 == 0 ? good[random() % good.size()] : static_cast<char>(random());
    folder_.write("a.mtl", bytes);
    EXPECT_EQ(read("mtllib a.mtl").size(), 4U);
    warned += warnings_.size();
  }
  EXPECT_GT(warned, 50U);
}

}  // namespace
}  // namespace lrcs
