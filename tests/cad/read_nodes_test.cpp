#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zip.h>

#include <random>

#include "base/input_error.h"
#include "cad/read_target.h"
#include "mesh/diagnosis.h"
#include "mesh/file_format.h"
#include "tests/cad/made_gltf.h"
#include "tests/scratch_folder.h"

namespace lrcs {
namespace {

using testing::ElementsAre;

// A 3MF file with a tetrahedron of edges of one unit, placed twice.
void write_3mf(const std::filesystem::path& file, const std::string& unit) {
  const std::string types =
      R"(<?xml version="1.0"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>)";
  const std::string relations =
      R"(<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)";
  const std::string model = R"(<?xml version="1.0"?><model )" + unit +
                            R"( xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>
<object id="1" type="model"><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/>
<vertex x="0" y="0" z="1"/></vertices><triangles><triangle v1="0" v2="2" v3="1"/><triangle v1="0" v2="1" v3="3"/>
<triangle v1="0" v2="3" v3="2"/><triangle v1="1" v2="2" v3="3"/></triangles></mesh></object></resources>
<build><item objectid="1"/><item objectid="1" transform="1 0 0 0 1 0 0 0 1 5 0 0"/></build></model>)";
  zip_t* archive = zip_open(file.c_str(), ZIP_CREATE | ZIP_TRUNCATE, nullptr);
  for (const auto& [name, content] : {std::pair<const char*, const std::string&>{"[Content_Types].xml", types},
                                      {"_rels/.rels", relations},
                                      {"3D/3dmodel.model", model}})
    zip_file_add(archive, name, zip_source_buffer(archive, content.data(), content.size(), 0), ZIP_FL_ENC_UTF_8);
  ASSERT_EQ(zip_close(archive), 0);
}

class ReadNodes : public testing::Test {
 protected:
  [[nodiscard]] TargetRead read(const std::string& content) const {
    folder_.write("made.gltf", content);
    return read_target(folder_.path() / "made.gltf");
  }
  [[nodiscard]] std::string complaint_about(const std::string& content) const {
    try {
      (void)read(content);
      return "none";
    } catch (const InputError& wrong) {
      return std::string(wrong.what()).substr(folder_.path().string().size() + 1);
    }
  }
  ScratchFolder folder_;
};

TEST_F(ReadNodes, PlacesEachNodeOfGltf) {
  const TargetRead target = read(gltf_of(
      R"({"name": "ship", "scale": [2, 2, 2], "children": [1, 2]}, {"name": "mast", "mesh": 0, "translation": [1, 0, 0]},
{"name": "mast", "mesh": 0, "translation": [-3, 0, 0], "scale": [-1, 1, 1]})"));
  EXPECT_EQ(target.unit, "m");
  EXPECT_THAT(target.mesh.part.names, ElementsAre("ship/mast:1", "ship/mast:2"));
  const Diagnosis d = diagnose(target.mesh);
  EXPECT_TRUE(d.closed);
  EXPECT_EQ(d.flipped, 0U);  // of the mirrored one either
  EXPECT_NEAR(d.volume, 8.0 / 3.0, 1e-14);
  EXPECT_EQ(d.box[0], Vec3(-8.0, 0.0, 0.0));
  EXPECT_EQ(d.box[1], Vec3(4.0, 2.0, 2.0));
  EXPECT_EQ(d.parts[1].file_material, "gold");
  EXPECT_EQ(d.parts[1].colour, "#ffbc00");  // 0.5 linear is 188 in sRGB
}

TEST_F(ReadNodes, NamesNodesWithoutANameAfterTheirMesh) {
  EXPECT_THAT(
      read(gltf_of(R"({"children": [1, 2]}, {"mesh": 0}, {"mesh": 0, "translation": [3, 0, 0]})")).mesh.part.names,
      ElementsAre("tetra:1", "tetra:2"));
}

TEST_F(ReadNodes, KnowsTheAxesOfTheFormat) {
  folder_.write("made.gltf", gltf_of(R"({"mesh": 0})"));
  const FileAxes axes = axes_of(folder_.path() / "made.gltf");
  EXPECT_STREQ(axes.forward, "+z");
  EXPECT_STREQ(axes.up, "+y");
  EXPECT_TRUE(has_unit(folder_.path() / "made.gltf"));
}

TEST_F(ReadNodes, ReadsTheUnitOf3mf) {
  for (const auto& [words, unit, metres] :
       {std::tuple{"unit=\"millimeter\"", "mm", 1e-3}, {"", "mm", 1e-3}, {"unit=\"inch\"", "inch", 0.0254}}) {
    write_3mf(folder_.path() / "made.3mf", words);
    const TargetRead target = read_target(folder_.path() / "made.3mf");
    EXPECT_EQ(target.unit, unit);
    EXPECT_THAT(target.warnings, testing::IsEmpty());
    EXPECT_THAT(target.mesh.file_material.names, ElementsAre(""));  // it names none
    const Diagnosis d = diagnose(target.mesh);
    EXPECT_EQ(d.parts.size(), 2U);
    EXPECT_NEAR(d.box[1].x(), 6.0 * metres, 1e-12);
    EXPECT_NEAR(d.volume, metres * metres * metres / 3.0, 1e-9 * metres * metres * metres);
    EXPECT_EQ(d.flipped, 0U);
  }
}

TEST_F(ReadNodes, FindsNoNormalsIn3mf) {
  write_3mf(folder_.path() / "made.3mf", "");
  Tessellation by_normals;
  by_normals.curving.by = Curving::By::file_normals;
  try {
    (void)read_target(folder_.path() / "made.3mf", "", by_normals);
    ADD_FAILURE();
  } catch (const InputError& wrong) {
    EXPECT_NE(std::string(wrong.what()).find("made.3mf: mesh '1' has no normals at its vertices"), std::string::npos)
        << wrong.what();
  }
}

// assimp leaves the facet out.
TEST_F(ReadNodes, WarnsOfAnIndexOfAVertexThatIsNotThere) {
  const TargetRead target = read(gltf_of(R"({"mesh": 0})", {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 9}));
  EXPECT_EQ(target.mesh.size(), 3U);
  ASSERT_EQ(target.warnings.size(), 1U);
  EXPECT_NE(target.warnings[0].find("out-of-range"), std::string::npos) << target.warnings[0];
}

TEST_F(ReadNodes, RefusesGltfThatWouldBeReadWrong) {
  std::string compressed = gltf_of(R"({"mesh": 0})"), quantized = compressed;
  compressed.replace(compressed.find("\"scene\""), 0, "\"extensionsRequired\": [\"KHR_draco_mesh_compression\"], ");
  EXPECT_EQ(complaint_about(compressed),
            "made.gltf: requires the extension KHR_draco_mesh_compression, expected glTF without it");
  quantized.replace(quantized.find("5126"), 4, "5123");
  EXPECT_EQ(complaint_about(quantized),
            "made.gltf: has positions that are not floats, expected glTF without quantization");
}

TEST_F(ReadNodes, IsAnInputErrorWhateverBytesAreChangedOrCutOff) {
  const std::string good = gltf_of(R"({"name": "ship", "children": [1]}, {"name": "mast", "mesh": 0})");
  std::mt19937_64 random(6);
  int refused = 0;
  for (int k = 0; k < 60; ++k) {
    std::string bytes = good.substr(0, k % 4 == 0 ? random() % good.size() : good.size());
    for (std::size_t flips = 1 + random() % 6; flips > 0 && !bytes.empty(); --flips)
      bytes[random() % bytes.size()] = static_cast<char>(32 + random() % 95);
    const std::string complaint = complaint_about(bytes);
    EXPECT_EQ(complaint.find('\n'), std::string::npos) << complaint;
    refused += complaint != "none" ? 1 : 0;
  }
  EXPECT_GT(refused, 20);
}

}  // namespace
}  // namespace lrcs
