// Every way a scene can be wrong: the exact message, exit status 2, and nothing written.
#include <gtest/gtest.h>

#include "tests/cli/made_scene.h"
#include "tests/cli/program.h"

namespace lrcs {
namespace {

struct BadScene {
  std::string name, piece, other, message;
};

void PrintTo(const BadScene& bad, std::ostream* out) {
  *out << bad.name;
}

const std::string after_all = "  elevation: 0\n";  // the last line of good_scene: what follows is on line 15

std::vector<BadScene> bad_scenes() {
  return {
      {"UnknownKey", "wavelength", "wavelenght",
       "2:1: unknown key 'wavelenght', did you mean 'wavelength'? (known: lrcs, wavelength, target, materials, assign, "
       "sweep, receiver, accuracy, output)"},
      {"DuplicateKey", "  unit: m\n", "  unit: m\n  unit: mm\n", "6:3: duplicate key 'unit' (first on line 5)"},
      {"WrongUnit", "unit: m\n", "unit: mmm\n",
       "5:9: unknown length unit 'mmm', did you mean 'mm'? (known: nm, um, mm, cm, dm, m, km, inch, in, ft, mil)"},
      {"MissingUnit", "  unit: m\n", "",
       "4:3: key 'unit' is missing: box.stl has no unit of its own; expected one of nm, um, mm, cm, dm, m, km, inch, "
       "in, ft, mil"},
      {"NaN", "step: 10", "step: .nan", "13:36: expected a finite number, found '.nan'"},
      {"NaNInAMaterial", "0.8", ".NaN", "8:40: expected a finite number, found '.NaN'"},
      {"MissingTarget", "target:\n  file: box.stl\n  unit: m\n", "", "1:1: key 'target' is missing"},
      {"MissingTargetFile", "box.stl", "bux.stl", "4:9: no such file: 'bux.stl'"},
      {"UpAlongForward", "unit: m\n", "unit: m\n  up: -x\n",
       "6:7: expected forward and up along different axes, found +x and -x"},
      {"UnknownSides", "unit: m\n", "unit: m\n  sides: back\n", "6:10: expected both or front, found 'back'"},
      {"UnknownRepair", "unit: m\n", "unit: m\n  repair: yes\n", "6:11: expected auto or none, found 'yes'"},
      {"ChordToleranceOfZero", "unit: m\n", "unit: m\n  chord_tolerance: 0\n",
       "6:20: expected a chord tolerance of 1e-7..0.5 of a part, found 0"},
      {"ChordToleranceWithoutUnit", "unit: m\n", "unit: m\n  chord_tolerance: fine\n",
       "6:20: expected a positive length with its unit, such as '1.06 um', found 'fine'"},
      {"ChordAngleTooLarge", "unit: m\n", "unit: m\n  chord_angle: 100\n",
       "6:16: expected 0.1..90 deg from edge to edge, found 100"},
      {"UnknownCurving", "unit: m\n", "unit: m\n  curved: normals\n",
       "6:11: expected auto, none, file_normals or crease:ANGLE with 1..89 deg, found 'normals'"},
      {"MissingFacetProperties", "unit: m\n", "unit: m\n  facet_properties: none.csv\n",
       "6:21: no such file: 'none.csv'"},
      {"UnmatchedColour", "part: \"panel*\"", "colour: \"#ff0000\"",
       "10:14: pattern '#ff0000' matches no colour of the target (the file has no colours)"},
      {"RuleByTwo", "part: \"panel*\"", "part: \"panel*\", colour: \"#ff0000\"",
       "10:6: expected either colour or part, found both"},
      {"UnmatchedPart", "panel*", "panle1",
       "10:12: pattern 'panle1' matches no part of the target, did you mean 'panel1'? (parts: 'body', 'panel1')"},
      {"UnmatchedFileMaterial", "part: \"panel*\"", "file_material: Gold",
       "10:21: pattern 'Gold' matches no material of the target (materials in the file: one without a name)"},
      {"FacetWithoutMaterial", "  - {default: white}\n", "",
       "10:3: 12 of 24 facets have no material, the first in part 'body': expected a rule for each, or a last rule "
       "{default: MATERIAL}"},
      {"UnknownMaterial", "default: white", "default: wihte",
       "11:15: unknown material 'wihte', did you mean 'white'? (materials: skin, white)"},
      {"UnknownBack", "part: \"panel*\"", "part: \"panel*\", back: wihte",
       "10:28: unknown material 'wihte', did you mean 'white'? (materials: skin, white)"},
      {"BackWithoutFront", "default: white", "part: body, back: white", "11:5: key 'material' is missing"},
      {"UnknownLibraryMaterial", "metal-skin-5p", "metal-skim-5p",
       "7:19: unknown library material 'metal-skim-5p', did you mean 'metal-skin-5p'? (known: metal-skin-5p, "
       "metal-skin-9p, painted-steel-5p, painted-steel-9p)"},
      {"MaterialThatIsAWord", "{library: metal-skin-5p}", "metal-skin-5p",
       "7:9: material 'skin': expected {library: NAME} or {model: NAME, ...}, found 'metal-skin-5p'"},
      {"MaterialNameOfTwoLines", "skin: {", "\"a\\nb\": {", "7:3: expected a material's name on one line"},
      {"ParameterOutsideItsDomain", "0.8", "1.8", "8:40: expected reflectance in [0, 1], found 1.8"},
      {"RuleWithoutMaterial", "default: white", "part: body", "11:5: key 'material' is missing"},
      {"RuleWithBoth", "default: white", "default: white, part: body",
       "11:22: expected either default or part, found both"},
      {"EmptyList", "{from: 0, to: 40, step: 10}", "[]", "13:12: the sweep is empty: expected at least one angle"},
      {"EmptyRange", "from: 0, to: 40", "from: 40, to: 0",
       "13:36: the sweep is empty: from 40 in steps of 10 never comes to 0"},
      {"EmptyDirections", "  azimuth: {from: 0, to: 40, step: 10}\n  elevation: 0\n", "  directions: []\n",
       "13:15: the sweep is empty: expected at least one [azimuth, elevation]"},
      {"StepZero", "step: 10", "step: 0", "13:36: expected a step other than 0 deg"},
      {"TooManyDirections", "step: 10", "step: 1e-9", "13:36: the sweep has more than 10000000 directions"},
      {"DirectionOfThreeNumbers", "  azimuth: {from: 0, to: 40, step: 10}\n  elevation: 0\n",
       "  directions: [[0, 1], [1, 2, 3]]\n", "13:24: expected [azimuth, elevation] in deg, found 3 values"},
      {"DirectionsAndAzimuth", "elevation: 0", "directions: [[0, 0]]",
       "13:3: expected either directions or azimuth, found both"},
      {"NoAzimuth", "  azimuth: {from: 0, to: 40, step: 10}\n", "", "13:3: key 'azimuth' or 'directions' is missing"},
      {"ElevationOf95", "elevation: 0", "elevation: [0, 95]", "14:18: expected an elevation of -90..90 deg, found 95"},
      {"AzimuthOf400", "from: 0", "from: 400", "13:19: expected an azimuth of -360..360 deg, found 400"},
      {"ListInAList", "{from: 0, to: 40, step: 10}", "[20, [10], 5]", "13:17: expected a number, found a list"},
      {"UnknownReceiver", after_all, after_all + "receiver: nowhere\n",
       "15:11: expected monostatic, {azimuth: A, elevation: E} or {bistatic_angle: B, plane: azimuth}, found "
       "'nowhere'"},
      {"HalfAReceiver", after_all, after_all + "receiver: {azimuth: 3}\n", "15:11: key 'elevation' is missing"},
      {"BistaticAngleOf200", after_all, after_all + "receiver: {bistatic_angle: 200}\n",
       "15:28: expected an angle of -180..180 deg, found 200"},
      {"UnknownPlane", after_all, after_all + "receiver: {bistatic_angle: 20, plane: roll}\n",
       "15:39: expected azimuth or elevation, found 'roll'"},
      {"TwoReceivers", after_all, after_all + "receiver: {bistatic_angle: 20, azimuth: 2}\n",
       "15:32: expected either bistatic_angle or azimuth, found both"},
      {"PlaneOfNoAngle", after_all, after_all + "receiver: {azimuth: 1, elevation: 2, plane: azimuth}\n",
       "15:38: plane belongs to bistatic_angle, which is missing"},
      {"UnknownAccuracy", after_all, after_all + "accuracy: fast\n",
       "15:11: expected exact or {relative: 1e-3}, found 'fast'"},
      {"AccuracyOfZero", after_all, after_all + "accuracy: {relative: 0}\n",
       "15:22: expected a number between 0 and 1, found 0"},
      {"FacetsOutsideTheSweep", after_all, after_all + "output: {facets: [{azimuth: 19, elevation: 0}]}\n",
       "15:19: azimuth 19, elevation 0 is no direction of the sweep; the nearest is azimuth 20, elevation 0"},
      {"UnknownFacets", after_all, after_all + "output: {facets: some}\n", "15:18: expected none or all, found 'some'"},
      {"FacetsThatAreNoList", after_all, after_all + "output: {facets: {azimuth: 0, elevation: 0}}\n",
       "15:18: expected none, all, or a list of {azimuth: A, elevation: E} in deg, found a mapping"},
      {"WrongVersion", "lrcs: 1", "lrcs: 2", "1:7: expected format version 1, found 2"},
      {"NoVersion", "lrcs: 1\n", "", "1:1: key 'lrcs' is missing: expected 'lrcs: 1', the version of the format"},
      {"WavelengthWithoutUnit", "1.06 um", "1.06",
       "2:13: expected a positive length with its unit, such as '1.06 um', found '1.06'"},
      {"SyntaxError", "{default: white}", "{default: white", "12:6: end of map flow not found"},
      {"AList", good_scene, "[1, 2]\n", "1:1: expected a mapping, found a list"},
      {"Binary", good_scene,
       "\x7f"
       "ELF\x02\x01",
       "1:1: byte 0x7f found, expected text in UTF-8"},
  };
}

class BadScenes : public testing::TestWithParam<BadScene> {};

TEST_P(BadScenes, AreToldApart) {
  const ScratchFolder folder;
  folder.write("box.stl", two_boxes());
  folder.write("scene.yaml", scene_with(GetParam().piece, GetParam().other));
  const std::string message = "lrcs: scene.yaml:" + GetParam().message + "\n";
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"sweep", "scene.yaml", "-o", "out"}, {"check", "scene.yaml"}}) {
    const Outcome outcome = run_lrcs(command, {folder.path()});
    EXPECT_EQ(outcome.status, 2) << command[0];
    EXPECT_EQ(outcome.err, message) << command[0];
    EXPECT_EQ(outcome.out, "") << command[0];
  }
  EXPECT_FALSE(folder.has("out"));
}

INSTANTIATE_TEST_SUITE_P(All, BadScenes, testing::ValuesIn(bad_scenes()),
                         [](const auto& tested) { return tested.param.name; });

TEST(SceneFile, ThatIsMissingEmptyOrAFolderIsToldSo) {
  const ScratchFolder folder;
  folder.write("empty.yaml", "");
  std::filesystem::create_directory(folder.path() / "folder.yaml");
  const std::vector<std::pair<std::string, std::string>> cases{
      {"none.yaml", "lrcs: none.yaml: cannot be read: No such file or directory\n"},
      {"empty.yaml", "lrcs: empty.yaml: is empty, expected YAML\n"},
      {"folder.yaml", "lrcs: folder.yaml: is a folder, expected a file\n"}};
  for (const auto& [file, message] : cases) {
    const Outcome outcome = run_lrcs({"sweep", file}, {folder.path()});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, message);
  }
}

TEST(SceneFile, NamesATargetAsItIsSeenFromTheWorkingFolder) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder.path() / "sub");
  folder.write("sub/scene.yaml", scene_with("box.stl", "../meshes/none.stl"));
  EXPECT_EQ(run_lrcs({"check", "sub/scene.yaml"}, {folder.path()}).err,
            "lrcs: sub/scene.yaml:4:9: no such file: 'sub/../meshes/none.stl'\n");
}

TEST(SceneFile, AllExamplesAreAccepted) {
  for (const char* name : {"propeller", "tess", "turbine"}) {
    const Outcome outcome = run_lrcs({"check", std::string(LRCS_EXAMPLES "/") + name + "/scene.yaml"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("scene.yaml: ok\n"), std::string::npos);
  }
}

TEST(OutputFolder, ThatCannotBeIsFoundBeforeAnythingIsComputed) {
  const ScratchFolder folder;
  folder.write("box.stl", two_boxes());
  folder.write("scene.yaml", good_scene);
  for (const std::string out : {"box.stl", "box.stl/below"}) {
    const Outcome outcome = run_lrcs({"sweep", "scene.yaml", "-o", out}, {folder.path()});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, "lrcs: " + out + ": cannot be made a folder for the results: Not a directory\n");
  }
  EXPECT_EQ(folder.read("box.stl"), two_boxes());
}

TEST(OutputFolder, OfAnEarlierRunIsNotTouchedByAWrongScene) {
  const ScratchFolder folder;
  folder.write("box.stl", two_boxes());
  folder.write("scene.yaml", good_scene);
  ASSERT_EQ(run_lrcs({"sweep", "scene.yaml", "-o", "out"}, {folder.path()}).status, 0);
  const std::string manifest = folder.read("out/manifest.json");
  folder.write("scene.yaml", scene_with(after_all, after_all + "output: {facets: [{azimuth: 5, elevation: 0}]}\n"));
  EXPECT_EQ(run_lrcs({"sweep", "scene.yaml", "-o", "out"}, {folder.path()}).status, 2);
  EXPECT_EQ(folder.read("out/manifest.json"), manifest);
}

}  // namespace
}  // namespace lrcs
