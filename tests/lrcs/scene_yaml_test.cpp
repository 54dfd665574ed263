#include "lrcs/scene_yaml.h"

#include <gtest/gtest.h>

#include "tests/scratch_folder.h"

namespace lrcs {
namespace {

const std::string every_key = R"(lrcs: 1
wavelength: 0.53217 um
target: {file: "in/a \"b\".step", unit: inch, forward: -y, up: +x, sides: both, repair: none, curved: "crease:31.5",
         chord_tolerance: 0.13 mm, chord_angle: 3.7, facet_properties: zones.csv}
materials:
  "skin: 1": {library: metal-skin-5p, azimuth_of_specular: 0}
  paint: {model: five_parameter, kb: 0.153, kr: 0.456, b: -26.998, a: 0.667, kd: 0.015, wavelength: 1.06 um, source: "a # b"}
  tape: {model: tabulated, file: in/retro.csv, outside: nearest}
assign:
  - {part: "panel[0-9]*", material: "skin: 1", back: paint}
  - {file_material: "?x", material: paint}
  - {colour: "#c0c0c0", material: paint}
  - {layer: "- a", material: paint}
  - {property: zone, value: "3", material: tape}
  - {default: paint, back: tape}
)";

class SceneYaml : public testing::Test {
 protected:
  SceneYaml() {
    std::filesystem::create_directories(folder_.path() / "in");
    std::filesystem::create_directories(folder_.path() / "out" / "deep");
    folder_.write("in/a \"b\".step", "");
    folder_.write("zones.csv", "");
    folder_.write("in/retro.csv",
                  "# wavelength: 532 nm\n# azimuth_of_specular: 180\n# value: brdf\ntheta_i_deg,theta_r_deg,phi_deg,"
                  "f_r_per_sr\n0,0,0,0.1\n20,20,0,0.2\n40,40,0,0.4\n60,60,0,0.5\n");
  }
  Scene read(const std::string& text) const {
    folder_.write("scene.yaml", text);
    return read_scene(folder_.path() / "scene.yaml");
  }
  // Written into another folder and read there.
  Scene again(const Scene& scene) const {
    const auto folder = folder_.path() / "out" / "deep";
    folder_.write("out/deep/again.yaml", scene_to_yaml(scene, folder));
    return read_scene(folder / "again.yaml");
  }
  ScratchFolder folder_;
};

TEST_F(SceneYaml, SaysEveryKeyOfTheTargetAndItsMaterials) {
  const Scene scene = read(every_key + "sweep: {azimuth: 0}\n"), same = again(scene);
  EXPECT_EQ(same.wavelength, scene.wavelength);
  const TargetFile &a = scene.target, &b = same.target;
  EXPECT_TRUE(std::filesystem::equivalent(a.file, b.file));
  EXPECT_TRUE(std::filesystem::equivalent(a.facet_properties, b.facet_properties));
  EXPECT_EQ(b.unit, "inch");
  EXPECT_EQ(b.forward, "-y");
  EXPECT_EQ(b.up, "+x");
  EXPECT_EQ(b.sides, a.sides);
  EXPECT_FALSE(b.repair);
  EXPECT_EQ(text_of(b.tessellation.curving), "crease:31.5");
  EXPECT_EQ(b.tessellation.absolute, a.tessellation.absolute);
  EXPECT_EQ(b.tessellation.angle_deg, 3.7);
  ASSERT_EQ(same.materials.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(same.materials[k].name, scene.materials[k].name);
    EXPECT_EQ(same.materials[k].source, scene.materials[k].source);
    EXPECT_EQ(same.materials[k].wavelength, scene.materials[k].wavelength);
    EXPECT_EQ(f_r_angles(same.materials[k].brdf, 0.5, 0.5, 0.0), f_r_angles(scene.materials[k].brdf, 0.5, 0.5, 0.0));
  }
  ASSERT_EQ(same.assign.size(), 6U);
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_EQ(same.assign[k].by, scene.assign[k].by);
    EXPECT_EQ(same.assign[k].pattern, scene.assign[k].pattern);
    EXPECT_EQ(same.assign[k].property, scene.assign[k].property);
    EXPECT_EQ(same.assign[k].material, scene.assign[k].material);
    EXPECT_EQ(same.assign[k].back, scene.assign[k].back);
  }
}

TEST_F(SceneYaml, SaysFrontSidesAndARelativeTolerance) {
  const Scene same =
      again(read("lrcs: 1\ntarget: {file: zones.csv, unit: m, sides: front, chord_tolerance: 3e-5}\n"
                 "materials: {w: {model: lambert, reflectance: 1}}\nassign: [{default: w}]\n"
                 "sweep: {azimuth: 0}\n"));
  EXPECT_EQ(same.target.sides, Sides::front);
  EXPECT_EQ(same.target.tessellation.relative, 3e-5);
  EXPECT_FALSE(same.target.tessellation.absolute);
  EXPECT_TRUE(same.target.repair);
}

TEST_F(SceneYaml, SaysTheSameDirectionsReceiverAccuracyAndFacets) {
  for (const std::string more :
       {"sweep: {azimuth: {from: 0, to: 1, step: 0.1}, elevation: [0.3, -2, 5]}\n",
        "sweep: {directions: [[17, 31], [200, -35], [17, 31]]}\nreceiver: {azimuth: 7.1, elevation: -8}\n",
        "sweep: {directions: [[1, 2], [3, 2], [1, 4]]}\nreceiver: {bistatic_angle: -12.5, plane: elevation}\n",
        "sweep: {azimuth: 3}\nreceiver: {bistatic_angle: 5}\naccuracy: {relative: 2e-3}\noutput: {facets: all}\n",
        "sweep: {azimuth: [3, 4], elevation: 1}\noutput: {facets: [{azimuth: 4, elevation: 1}]}\n"}) {
    const Scene scene = read(every_key + more), same = again(scene);
    EXPECT_EQ(same.directions, scene.directions) << more;
    EXPECT_EQ(same.receiver.kind, scene.receiver.kind) << more;
    EXPECT_EQ(same.receiver.fixed, scene.receiver.fixed) << more;
    EXPECT_EQ(same.receiver.bistatic_angle_deg, scene.receiver.bistatic_angle_deg) << more;
    EXPECT_EQ(same.receiver.plane, scene.receiver.plane) << more;
    EXPECT_EQ(same.relative_accuracy, scene.relative_accuracy) << more;
    EXPECT_EQ(same.facets.all, scene.facets.all) << more;
    EXPECT_EQ(same.facets.directions, scene.facets.directions) << more;
  }
}

}  // namespace
}  // namespace lrcs
