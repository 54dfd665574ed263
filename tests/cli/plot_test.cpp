// Plots of sweeps that are done: what is drawn, from which files, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/cli/made_scene.h"
#include "tests/cli/program.h"

namespace lrcs {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// Sweeps of the two boxes: `scene` is one cut, `grid` has three, `up` is one against elevation.
class Plot : public testing::Test {
 protected:
  Plot() {
    folder_.write("box.stl", two_boxes());
    folder_.write("scene.yaml", good_scene);
    const std::string angles = "azimuth: {from: 0, to: 40, step: 10}\n  elevation: 0";
    folder_.write("grid.yaml", scene_with(angles, "azimuth: {from: 0, to: 330, step: 30}\n  elevation: [-30, 0, 30]"));
    folder_.write("up.yaml", scene_with(angles, "azimuth: 10\n  elevation: {from: -20, to: 20, step: 10}"));
  }
  void sweep(const Words& names) const {
    for (const std::string& name : names)
      EXPECT_EQ(run_lrcs({"sweep", name + ".yaml", "-o", name, "-q"}, {folder_.path()}).status, 0);
  }
  [[nodiscard]] Outcome plot(const Words& words) const { return run_lrcs(with({"plot"}, words), {folder_.path()}); }
  // The SVG that is drawn.
  [[nodiscard]] std::string svg(const Words& words) const {
    const Outcome outcome = plot(with(words, {"-o", "a.svg"}));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return folder_.read("a.svg");
  }
  [[nodiscard]] std::string complaint(const Words& words) const {
    const Outcome outcome = plot(words);
    EXPECT_EQ(outcome.status, 2) << words[0];
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_FALSE(folder_.has("plot.png"));
    return outcome.err;
  }
  ScratchFolder folder_;
};

TEST_F(Plot, DrawsEveryKindOfItAndNeedsNoDisplay) {
  sweep({"grid"});
  for (const char* kind : {"cut", "polar", "map", "sphere", "parts"}) {
    const Words words{"plot", "grid", "--kind", kind, "-o", std::string(kind) + ".png"};
    const Words one_cut = std::string(kind) == "parts" ? with(words, {"--elevation", "0"}) : words;
    const Outcome outcome = run_lrcs(one_cut, {folder_.path(), {{"DISPLAY", ""}}});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(folder_.read(std::string(kind) + ".png").substr(1, 3), "PNG");
  }
}

TEST_F(Plot, IsWrittenToPlotPngUnlessTold) {
  sweep({"scene"});
  ASSERT_EQ(plot({"scene"}).status, 0);
  EXPECT_EQ(folder_.read("plot.png").substr(1, 3), "PNG");
}

TEST_F(Plot, IsThatOfTheSweepItself) {
  sweep({"grid"});
  ASSERT_EQ(plot({"grid", "-o", "cut.png"}).status, 0);
  EXPECT_EQ(folder_.read("cut.png"), folder_.read("grid/sweep.png"));
  ASSERT_EQ(plot({"grid", "--kind", "polar", "-o", "polar.png"}).status, 0);
  EXPECT_EQ(folder_.read("polar.png"), folder_.read("grid/polar.png"));
  ASSERT_EQ(plot({"grid", "--kind", "map", "-o", "map.png"}).status, 0);
  EXPECT_EQ(folder_.read("map.png"), folder_.read("grid/map.png"));
}

TEST_F(Plot, TakesTheTableInPlaceOfItsFolder) {
  sweep({"grid"});
  EXPECT_EQ(svg({"grid/sweep.csv", "--kind", "map"}), svg({"grid", "--kind", "map"}));
  folder_.write("other.csv", folder_.read("grid/sweep.csv"));
  EXPECT_THAT(svg({"other.csv"}), HasSubstr(">Monostatic LRCS of other<"));
}

TEST_F(Plot, SaysWhatItShows) {
  sweep({"grid"});
  const std::string one = svg({"grid", "--elevation", "30"});
  EXPECT_THAT(one, HasSubstr(">Monostatic LRCS of box.stl<"));
  EXPECT_THAT(one, HasSubstr(">azimuth [deg] at elevation 30 deg<"));
  const std::string all = svg({"grid", "--title", "Two boxes & more"});
  EXPECT_THAT(all, HasSubstr(">Two boxes &amp; more<"));
  for (const char* label : {"elevation -30 deg", "elevation 0 deg", "elevation 30 deg"})
    EXPECT_THAT(all, HasSubstr(">" + std::string(label) + "<"));
  EXPECT_THAT(svg({"grid", "--azimuth", "60"}), HasSubstr(">elevation [deg] at azimuth 60 deg<"));
}

// Not drawn across directions that nobody computed, and rows are not degrees.
TEST_F(Plot, DrawsOnlyWhereTheSweepWas) {
  const std::string angles = "azimuth: {from: 0, to: 40, step: 10}\n  elevation: 0";
  folder_.write("nose.yaml", scene_with(angles, "azimuth: [330, 345, 0, 15, 30]\n  elevation: 0"));
  sweep({"nose"});
  const std::string nose = svg({"nose"});
  for (const char* mark : {"−30", "0", "30"}) EXPECT_THAT(nose, HasSubstr(">" + std::string(mark) + "<"));
  EXPECT_THAT(nose, Not(HasSubstr(">180<")));
  folder_.write("map.yaml", scene_with(angles, "azimuth: [330, 345, 0, 15, 30]\n  elevation: [0, 10]"));
  sweep({"map"});
  EXPECT_THAT(svg({"map", "--kind", "map"}), AllOf(HasSubstr(">−30<"), Not(HasSubstr(">180<"))));
  folder_.write("scattered.yaml",
                scene_with("azimuth: {from: 0, to: 40, step: 10}\n  elevation: 0", "directions: [[1, 2], [50, 30]]"));
  sweep({"scattered"});
  const std::string rows = svg({"scattered"});
  EXPECT_THAT(rows, HasSubstr(">row of sweep.csv<"));
  EXPECT_THAT(rows, HasSubstr(">1<"));
  EXPECT_THAT(rows, Not(HasSubstr(">0.5<")));
}

TEST_F(Plot, ComparesSweepsByTheNamesOfTheirFolders) {
  sweep({"scene", "grid"});
  const std::string both = svg({"scene", "./grid/", "--elevation", "0"});
  EXPECT_THAT(both, HasSubstr(">scene<"));
  EXPECT_THAT(both, HasSubstr(">grid<"));
  EXPECT_THAT(both, HasSubstr(">azimuth [deg] at elevation 0 deg<"));
  const std::string named = svg({"scene", "grid", "--elevation", "0", "--label", "fine", "--label", "coarse"});
  EXPECT_THAT(named, HasSubstr(">fine<"));
  EXPECT_THAT(named, HasSubstr(">coarse<"));
  EXPECT_THAT(named, Not(HasSubstr(">grid<")));
  std::filesystem::create_directories(folder_.path() / "old");
  std::filesystem::copy(folder_.path() / "scene", folder_.path() / "old" / "scene");
  const std::string alike = svg({"scene", "old/scene"});
  EXPECT_THAT(alike, HasSubstr(">scene<"));
  EXPECT_THAT(alike, HasSubstr(">old/scene<"));
}

TEST_F(Plot, ShowsTheBoundsOfASampledSweep) {
  folder_.write("box.stl", stl_sphere(60) + stl_box("panel1", {0.5, 0.9, -0.3}, {1.5, 2, 0.3}));
  folder_.write("sampled.yaml", good_scene + "accuracy: {relative: 0.01}\n");
  sweep({"sampled", "scene"});
  EXPECT_THAT(svg({"sampled", "--floor", "3"}), HasSubstr(">Band: bound (LRCS − bound to LRCS + bound)<"));
  EXPECT_THAT(svg({"scene"}), Not(HasSubstr("Band")));
}

TEST_F(Plot, StartsAtTheFloorAndHasTheSizeAskedFor) {
  sweep({"grid"});
  const std::string text = svg({"grid", "--floor", "6", "--size", "1300x900"});
  EXPECT_THAT(text, HasSubstr(">No line where LRCS is 0 or below 6 dBsm<"));
  EXPECT_THAT(text, HasSubstr("viewBox=\"0 0 1300 900\""));
  const std::string sphere = svg({"grid", "--kind", "sphere", "--from", "-90,0"});
  EXPECT_THAT(sphere, HasSubstr(">seen from azimuth −90°, elevation 0°<"));
  EXPECT_THAT(sphere, HasSubstr(">seen from azimuth 90°, elevation 0°<"));
}

TEST_F(Plot, GivesTheSameBytesTwiceAndForAnyNumberOfThreads) {
  sweep({"grid"});
  const Words parts{"grid", "--kind", "parts", "--elevation", "30"};
  EXPECT_EQ(svg(with(parts, {"-t", "1"})), svg(with(parts, {"-t", "4"})));
}

TEST_F(Plot, NamesThePartsThatReturn) {
  sweep({"up"});
  const std::string parts = svg({"up", "--kind", "parts"});
  EXPECT_THAT(parts, HasSubstr(">body<"));
  EXPECT_THAT(parts, HasSubstr(">panel1<"));
  EXPECT_THAT(parts, HasSubstr(">LRCS [m²]<"));
  EXPECT_THAT(parts, HasSubstr(">elevation [deg] at azimuth 10 deg<"));
  EXPECT_THAT(parts, Not(HasSubstr(">others<")));
}

TEST_F(Plot, OfAGridIsAnOutputOfItsSweep) {
  sweep({"scene", "grid"});
  EXPECT_TRUE(folder_.has("grid/map.png"));
  EXPECT_FALSE(folder_.has("scene/map.png"));
  const auto lists_map = [&](const std::string& sweep) {
    const auto manifest = nlohmann::json::parse(folder_.read(sweep + "/manifest.json"));
    for (const auto& output : manifest["outputs"])
      if (output["file"] == "map.png") return true;
    return false;
  };
  EXPECT_TRUE(lists_map("grid"));
  EXPECT_FALSE(lists_map("scene"));
}

TEST_F(Plot, SaysWhatIsWrong) {
  sweep({"scene", "grid", "up"});
  folder_.write("words.csv", "a,b\n1,2\n");
  std::filesystem::create_directories(folder_.path() / "empty");
  const std::vector<std::pair<Words, std::string>> wrong{
      {{"nowhere"}, "nowhere: no such file: expected a folder that lrcs sweep wrote, or a sweep.csv"},
      {{"empty"}, "empty: holds no sweep.csv: expected a folder that lrcs sweep wrote"},
      {{"words.csv"}, "words.csv:1:1: expected the column transmitter_azimuth_deg of a sweep.csv, found 'a'"},
      {{"grid", "scene"},
       "grid: has 3 cuts (elevation -30 deg, elevation 0 deg, elevation 30 deg), expected one: choose it by "
       "--elevation "
       "or --azimuth"},
      {{"grid", "--elevation", "20"},
       "--elevation: grid has no cut at 20 deg; it has elevation -30 deg, elevation 0 deg, elevation 30 deg"},
      {{"scene", "--azimuth", "15"}, "--azimuth: scene has no cut at 15 deg; it has azimuth 0 deg, azimuth 10 deg, "},
      {{"scene", "up"}, "up: its cut is against elevation [deg], expected azimuth [deg] as of scene"},
      {{"grid", "--elevation", "0", "--azimuth", "0"},
       "--azimuth: expected either --azimuth or --elevation, found both"},
      {{"grid", "--elevation", "low"}, "--elevation: expected a number, found 'low'"},
      {{"scene", "--kind", "map"},
       "scene: --kind map: expected a sweep over a grid of two or more azimuths and elevations"},
      {{"up", "--kind", "sphere"}, "up: --kind sphere: expected a sweep over a grid"},
      {{"grid", "scene", "--kind", "map"}, "--kind map: expected one sweep, found 2"},
      {{"grid", "--kind", "sphere", "--from", "30"}, "--from: expected AZIMUTH,ELEVATION in deg, found '30'"},
      {{"grid", "--from", "30,20"}, "--from: belongs to --kind sphere, found beside --kind cut"},
      {{"grid", "--kind", "map", "--label", "x"}, "--label: belongs to --kind cut or polar, found beside --kind map"},
      {{"grid", "--kind", "map", "--elevation", "0"}, "--elevation: belongs to --kind cut, polar or parts"},
      {{"scene", "--label", "x", "--label", "y"}, "--label: expected one for each of 1 sweeps, found 2"},
      {{"scene", "--floor", "90"}, "--floor: expected less than the highest LRCS, "},
      {{"scene", "--floor", "-1e9"}, "--floor: expected less than the highest LRCS, "},
      {{"scene", "--kind", "parts", "--floor", "0"}, "--floor: belongs to --kind cut, polar, map or sphere"},
      {{"scene", "--size", "100x100"}, "--size: expected WIDTHxHEIGHT, 400x250 to 8000x8000 pixels, found '100x100'"},
      {{"scene", "--size", "1600"}, "--size: expected WIDTHxHEIGHT"},
      {{"scene", "--kind", "part"},
       "--kind: expected cut, polar, map, sphere or parts, found 'part', did you mean 'parts'?"},
      {{"scene", "-o", "a.pdf"}, "a.pdf: expected a file for a plot, that ends in .png or .svg"},
      {{"scene", "-o", "none/a.svg"}, "--output: no such folder: 'none'"},
      {{"grid", "--kind", "parts"}, "grid: has 3 cuts"},
      {{"grid/sweep.csv", "--kind", "parts", "--elevation", "0"},
       "grid/sweep.csv: --kind parts: expected a folder that lrcs sweep wrote: its target is read"},
      {{"scene", "--kind", "parts", "--azimuth", "10"},
       "scene: --kind parts: expected a cut of two directions or more, found one"},
      {{"a", "b", "c", "d", "e", "f", "g", "h"}, "expected at most 7 sweeps to compare, found 8"}};
  for (const auto& [words, message] : wrong) EXPECT_THAT(complaint(words), HasSubstr("lrcs: " + message)) << words[0];
}

TEST_F(Plot, OfPartsNeedsTheTargetAsItWas) {
  sweep({"scene"});
  folder_.write("box.stl", two_boxes() + "\n");
  EXPECT_THAT(complaint({"scene", "--kind", "parts"}), HasSubstr("box.stl: has changed since the sweep"));
  EXPECT_EQ(plot({"scene", "--kind", "cut", "-o", "cut.png"}).status, 0);
}

TEST_F(Plot, SaysOnceThatNoFontHasItsLetters) {
  sweep({"scene"});
  folder_.write("none.conf", "<?xml version=\"1.0\"?><fontconfig></fontconfig>");
  const Surroundings without_fonts{folder_.path(), {{"FONTCONFIG_FILE", (folder_.path() / "none.conf").string()}}};
  const Words words{"plot", "scene", "--title", "太阳能板 #2", "--label", "阳", "-o"};
  const Outcome outcome = run_lrcs(with(words, {"without.png"}), without_fonts);
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("lrcs: warning: no installed font has 4 letters of"));
  EXPECT_THAT(outcome.err, HasSubstr("drawn as <U+592A>: install a font that has them, such as fonts-noto-cjk"));
  EXPECT_EQ(run_lrcs(with(words, {"quiet.png", "-q"}), without_fonts).err, "");
  // A viewer may have them.
  EXPECT_EQ(run_lrcs(with(words, {"without.svg"}), without_fonts).err, "");
  EXPECT_THAT(folder_.read("without.svg"), HasSubstr(">太阳能板 #2<"));
  EXPECT_EQ(run_lrcs(with(words, {"with.png"}), {folder_.path()}).err, "");
  EXPECT_NE(folder_.read("with.png"), folder_.read("without.png"));
}

}  // namespace
}  // namespace lrcs
