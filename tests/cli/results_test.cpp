// What a sweep writes: every file read back and compared with what it should hold.
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/digest.h"
#include "base/version.h"
#include "lrcs/scene_target.h"
#include "lrcs/sweep.h"
#include "tests/cli/made_scene.h"
#include "tests/cli/program.h"

namespace lrcs {
namespace {

using Json = nlohmann::json;

struct Table {
  std::vector<std::string> comments;
  std::string header;
  std::vector<std::vector<double>> rows;
};

double number_of(const std::string& word) {
  if (word == "-inf") return -INFINITY;
  double value = NAN;
  const auto [end, wrong] = std::from_chars(word.data(), word.data() + word.size(), value);
  return wrong == std::errc{} && end == word.data() + word.size() ? value : NAN;
}

Table table_of(const std::string& csv) {
  Table table;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) {
      table.comments.push_back(line);
    } else if (table.header.empty()) {
      table.header = line;
    } else {
      std::istringstream words(line);
      table.rows.emplace_back();
      for (std::string word; std::getline(words, word, ',');) table.rows.back().push_back(number_of(word));
    }
  }
  return table;
}

constexpr std::size_t sigma_column = 4, dbsm_column = 5, bound_column = 6, seen_area_column = 7;

// The two boxes and their scene, with a change to it.
class Sweep : public testing::Test {
 protected:
  Sweep() {
    folder_.write("box.stl", two_boxes());
    folder_.write("scene.yaml", good_scene);
  }
  Outcome run(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"sweep", "scene.yaml", "-o", "out"};
    words.insert(words.end(), more.begin(), more.end());
    return run_lrcs(words, {folder_.path()});
  }
  void ask_for(const std::string& facets) const {
    folder_.write("scene.yaml", good_scene + "output: {facets: " + facets + "}\n");
  }
  [[nodiscard]] Table table() const { return table_of(folder_.read("out/sweep.csv")); }
  [[nodiscard]] Json manifest() const { return Json::parse(folder_.read("out/manifest.json")); }
  [[nodiscard]] vtkSmartPointer<vtkPolyData> facets(int k) const {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName((folder_.path() / ("out/facets-" + std::to_string(k) + ".vtp")).c_str());
    reader->Update();
    return reader->GetOutput();
  }

  ScratchFolder folder_;
};

TEST_F(Sweep, HasExactlyTheColumnsAskedFor) {
  ASSERT_EQ(run().status, 0);
  EXPECT_EQ(table().header,
            "transmitter_azimuth_deg,transmitter_elevation_deg,receiver_azimuth_deg,receiver_elevation_deg,sigma_m2,"
            "sigma_dbsm,bound_m2,seen_area_m2");
}

TEST_F(Sweep, WritesNumbersThatReadBackToTheComputedDoubles) {
  folder_.write("scene.yaml", good_scene + "receiver: {bistatic_angle: 25, plane: elevation}\n");
  ASSERT_EQ(run().status, 0);
  const Scene scene = read_scene(folder_.path() / "scene.yaml");
  const LoadedTarget loaded = load_target(scene);
  std::vector<Aspect> aspects;
  for (const auto& direction : scene.directions) aspects.push_back(aspect_of(direction, scene.receiver));
  const auto rows = run_sweep(loaded.target, aspects, 1);
  const Table written = table();
  ASSERT_EQ(written.rows.size(), rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto& [transmitter, receiver, di, dr] = rows[k].aspect;
    const std::vector<double> expected{transmitter.azimuth_deg, transmitter.elevation_deg,
                                       receiver.azimuth_deg,    receiver.elevation_deg,
                                       rows[k].sigma.value,     10.0 * std::log10(rows[k].sigma.value),
                                       rows[k].sigma.bound,     rows[k].seen_area};
    EXPECT_EQ(written.rows[k], expected);
    EXPECT_GT(rows[k].sigma.value, 0.0);
  }
}

TEST_F(Sweep, SamplesToARelativeAccuracyWithinItsBoundAndSaysHowManyRows) {
  folder_.write("box.stl", stl_sphere(60) + stl_box("panel1", {0.5, 0.9, -0.3}, {1.5, 2, 0.3}));
  ASSERT_EQ(run().status, 0);
  const Table exact = table();
  EXPECT_EQ(manifest().at("rows").at("sampled"), 0);
  EXPECT_EQ(manifest().at("method"), "exact seen area of every facet");
  folder_.write("scene.yaml", good_scene + "accuracy: {relative: 0.01}\n");
  ASSERT_EQ(run().status, 0);
  const Table sampled = table();
  EXPECT_EQ(manifest().at("rows").at("sampled"), 5);
  EXPECT_EQ(manifest().at("rows").at("exact"), 0);
  EXPECT_EQ(manifest().at("method"), "row grids");
  EXPECT_EQ(manifest().at("accuracy").at("relative"), 0.01);
  for (std::size_t k = 0; k < exact.rows.size(); ++k) {
    const double sigma = sampled.rows[k][sigma_column], bound = sampled.rows[k][bound_column];
    EXPECT_LE(bound, 0.01 * sigma);
    EXPECT_GT(bound, 1e-6 * sigma) << "exact";
    EXPECT_LE(std::abs(sigma - exact.rows[k][sigma_column]), bound);
    EXPECT_NEAR(sampled.rows[k][seen_area_column], exact.rows[k][seen_area_column], 0.02);
  }
}

TEST_F(Sweep, SaysInItsCommentsWhatTheNumbersAre) {
  ASSERT_EQ(run().status, 0);
  const auto comments = table().comments;
  const std::vector<std::string> expected{std::string("# lrcs ") + version + ": laser radar cross section",
                                          "# scene sha256: " + digest_of(good_scene),
                                          "# target sha256: " + digest_of(two_boxes()), "# wavelength: 1.06 um"};
  for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_EQ(comments.at(k), expected[k]);
  std::string all;
  for (const auto& line : comments) all += line + "\n";
  for (const char* words :
       {"azimuth from +x (forward) toward +y", "elevation from the xy-plane toward +z",
        "dBsm = 10 log10(sigma / 1 m^2)", "material white: model: lambert, reflectance: 0.8", "bound", "seen area"})
    EXPECT_NE(all.find(words), std::string::npos) << words;
}

TEST_F(Sweep, PrintsMinusInfinityWhereNothingComesBack) {
  folder_.write("box.stl", "solid plate\n" + stl_facet({0, 0, 0}, {0, 1, 0}, {0, 0, 1}) + "endsolid plate\n");
  std::string text = scene_with("unit: m\n", "unit: m\n  sides: front\n");
  text.replace(text.find("panel*"), 6, "pl*");
  text.replace(text.find("to: 40, step: 10"), 16, "to: 180, step: 180");
  folder_.write("scene.yaml", text);
  const Outcome outcome = run();
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Table written = table();
  EXPECT_GT(written.rows.at(0)[sigma_column], 0.0);
  EXPECT_EQ(written.rows.at(1)[sigma_column], 0.0);
  EXPECT_EQ(written.rows.at(1)[dbsm_column], -INFINITY);
  EXPECT_NE(folder_.read("out/sweep.csv").find("180,0,180,0,0,-inf,"), std::string::npos);
}

TEST_F(Sweep, GivesTheSameBytesForAnyNumberOfThreadsAndAnyRun) {
  folder_.write("box.stl", stl_sphere(8));
  std::string text = good_scene + "output: {facets: all}\n";
  text.replace(text.find("panel*"), 6, "b*");
  folder_.write("scene.yaml", text);
  ASSERT_EQ(run({"-t", "1"}).status, 0);
  const std::string csv = folder_.read("out/sweep.csv");
  std::vector<std::string> files;
  for (int k = 0; k < 5; ++k) files.push_back(folder_.read("out/facets-" + std::to_string(k) + ".vtp"));
  for (const char* threads : {"1", "2", "4"}) {
    ASSERT_EQ(run({"-t", threads}).status, 0);
    EXPECT_EQ(folder_.read("out/sweep.csv"), csv) << threads;
    for (std::size_t k = 0; k < 5; ++k)
      EXPECT_EQ(folder_.read("out/facets-" + std::to_string(k) + ".vtp"), files[k]) << threads;
  }
  EXPECT_FALSE(files[4].empty());
  EXPECT_EQ(manifest()["threads"], 4);
}

TEST_F(Sweep, WritesFacetsWhoseSharesSumToSigma) {
  ask_for("all");
  ASSERT_EQ(run().status, 0);
  const Table written = table();
  for (int k = 0; k < 5; ++k) {
    const auto data = facets(k);
    ASSERT_EQ(data->GetNumberOfCells(), 24);
    for (const char* name : {"part", "material", "source_facet", "seen_fraction", "sigma_m2"})
      ASSERT_NE(data->GetCellData()->GetArray(name), nullptr) << name;
    double sum = 0.0;
    for (vtkIdType j = 0; j < 24; ++j) {
      sum += data->GetCellData()->GetArray("sigma_m2")->GetTuple1(j);
      const double fraction = data->GetCellData()->GetArray("seen_fraction")->GetTuple1(j);
      EXPECT_TRUE(fraction >= 0.0 && fraction <= 1.0) << fraction;
    }
    const double sigma = written.rows.at(static_cast<std::size_t>(k))[sigma_column];
    EXPECT_NEAR(sum, sigma, 1e-12 * sigma);
    EXPECT_EQ(data->GetFieldData()->GetArray("sigma_total_m2")->GetTuple1(0), sigma);
    EXPECT_EQ(data->GetFieldData()->GetArray("transmitter_azimuth_deg")->GetTuple1(0), 10.0 * k);
  }
}

// A sheet with its front up, seen from above and below.
TEST_F(Sweep, TellsTheMaterialOfTheSideThatIsSeen) {
  folder_.write("sheet.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  folder_.write("scene.yaml", R"(lrcs: 1
target: {file: sheet.off, unit: m}
materials: {cells: {model: lambert, reflectance: 0.1}, foil: {model: lambert, reflectance: 0.9}}
assign: [{part: "*", material: cells, back: foil}]
sweep: {azimuth: 0, elevation: [90, -90]}
output: {facets: all}
)");
  ASSERT_EQ(run().status, 0);
  for (const int k : {0, 1}) {
    const double reflectance = k == 0 ? 0.1 : 0.9;
    EXPECT_EQ(facets(k)->GetCellData()->GetArray("material")->GetTuple1(0), k);
    EXPECT_NEAR(table().rows.at(static_cast<std::size_t>(k))[sigma_column], 4.0 * reflectance * 0.5, 1e-12);
  }
  const Json json = manifest();
  EXPECT_EQ(json["assign"], Json::parse(R"([{"part": "*", "material": "cells", "back": "foil"}])"));
  EXPECT_EQ(json["materials"][0]["facets"], 1);
  EXPECT_EQ(json["materials"][0]["backs"], 0);
  EXPECT_EQ(json["materials"][1]["facets"], 0);
  EXPECT_EQ(json["materials"][1]["backs"], 1);
  EXPECT_NE(run_lrcs({"check", "scene.yaml"}, {folder_.path()}).out.find("material    foil: 0 facets, 1 from behind\n"),
            std::string::npos);
}

TEST_F(Sweep, NumbersFacetFilesByTheirPlaceInTheSceneAndSaysTheirDirections) {
  ask_for("[{azimuth: 30, elevation: 0}, {azimuth: 0, elevation: 0}]");
  ASSERT_EQ(run().status, 0);
  const Json json = manifest();
  const Json& files = json["facets"];
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0]["file"], "facets-0.vtp");
  EXPECT_EQ(files[0]["row"], 3);
  EXPECT_EQ(files[0]["transmitter_azimuth_deg"], 30.0);
  EXPECT_EQ(files[0]["transmitter_elevation_deg"], 0.0);
  EXPECT_EQ(files[0]["receiver_azimuth_deg"], 30.0);
  EXPECT_EQ(files[1]["file"], "facets-1.vtp");
  EXPECT_EQ(files[1]["row"], 0);
  EXPECT_EQ(facets(0)->GetFieldData()->GetArray("transmitter_azimuth_deg")->GetTuple1(0), 30.0);
  EXPECT_EQ(facets(1)->GetFieldData()->GetArray("transmitter_azimuth_deg")->GetTuple1(0), 0.0);
  EXPECT_FALSE(folder_.has("out/facets-2.vtp"));
}

TEST_F(Sweep, ListsInputsAndOutputsWithTheirDigests) {
  ask_for("[{azimuth: 20, elevation: 0}]");
  ASSERT_EQ(run({"-t", "2"}).status, 0);
  const Json json = manifest();
  EXPECT_EQ(json["version"], version);
  EXPECT_EQ(json["scene"]["file"], "scene.yaml");
  EXPECT_EQ(json["scene"]["sha256"], digest_of(folder_.read("scene.yaml")));
  EXPECT_EQ(json["target"]["file"], "box.stl");
  EXPECT_EQ(json["target"]["sha256"], digest_of(two_boxes()));
  EXPECT_EQ(json["target"]["repaired"]["welded_vertices"], 56);
  EXPECT_EQ(json["command"], Json({"lrcs", "sweep", "scene.yaml", "-o", "out", "-t", "2"}));
  EXPECT_EQ(json["directions"], 5);
  EXPECT_EQ(json["skipped"]["monostatic_directions"], 5);
  EXPECT_EQ(json["skipped"]["convex_facets"], 0);
  // Of the body all but the side at the panel, of the panel its far end.
  EXPECT_EQ(json["skipped"]["hull_facets"], 12);
  EXPECT_EQ(json["skipped"]["parts_apart"], 0);
  EXPECT_EQ(json["skipped"]["facets_never_faced"], 0);
  EXPECT_TRUE(json["skipped"].contains("free_convex_parts"));
  EXPECT_EQ(json["accuracy"], "exact");
  std::vector<std::string> names;
  for (const auto& output : json["outputs"]) {
    names.push_back(output["file"]);
    EXPECT_EQ(output["sha256"], digest_of(folder_.read("out/" + names.back()))) << names.back();
  }
  std::size_t in_folder = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path() / "out"))
    in_folder += entry.path().filename() == "manifest.json" ? 0 : 1;
  EXPECT_EQ(in_folder, names.size());
}

TEST_F(Sweep, RecordsTheTableOfFacetPropertiesThatItAssignedBy) {
  folder_.write("zones.csv", "facet,zone\n3,hot\n11,hot\n");
  folder_.write("scene.yaml", R"(lrcs: 1
target: {file: box.stl, unit: m, facet_properties: zones.csv}
materials: {white: {model: lambert, reflectance: 1}, black: {model: lambert, reflectance: 0}}
assign: [{property: zone, value: hot, material: black}, {default: white}]
sweep: {azimuth: 0}
)");
  ASSERT_EQ(run().status, 0);
  const Json json = manifest();
  EXPECT_EQ(json["target"]["facet_properties"]["file"], "zones.csv");
  EXPECT_EQ(json["target"]["facet_properties"]["sha256"], digest_of(folder_.read("zones.csv")));
  EXPECT_EQ(json["materials"][1]["facets"], 2);
  EXPECT_EQ(json["assign"][0], Json::parse(R"({"property": "zone", "value": "hot", "material": "black"})"));
  folder_.write("zones.csv", "facet,zone\n24,hot\n");
  const Outcome wrong = run();
  EXPECT_EQ(wrong.status, 2);
  EXPECT_EQ(wrong.err, "lrcs: zones.csv:2:1: expected the number of a facet, 0 to 23, found '24'\n");
}

TEST_F(Sweep, WarnsOfAMaterialForAnotherWavelengthAndNamesBoth) {
  folder_.write("scene.yaml", scene_with("1.06 um", "1.55 um"));
  const std::string warning = "material 'skin' is for 1.06 um, the scene is at 1.55 um";
  EXPECT_NE(run().err.find("lrcs: warning: " + warning + "\n"), std::string::npos);
  EXPECT_EQ(manifest()["warnings"], Json({warning}));
  EXPECT_EQ(run_lrcs({"check", "scene.yaml"}, {folder_.path()}).err, "lrcs: warning: " + warning + "\n");
  EXPECT_EQ(run({"-q"}).err, "");
  EXPECT_EQ(manifest()["warnings"], Json({warning}));
}

TEST_F(Sweep, BySceneAndByFlagsGivesTheSameNumbers) {
  folder_.write("scene.yaml", scene_with("skin: {library: metal-skin-5p}", "skin: {model: lambert, reflectance: 0.8}"));
  ASSERT_EQ(run_lrcs({"sweep", "scene.yaml"}, {folder_.path()}).status, 0);
  const Outcome outcome = run_lrcs({"sweep", "box.stl", "--unit", "m", "--material", "lambert:0.8", "--azimuth",
                                    "0:40:10", "--wavelength", "1.06 um"},
                                   {folder_.path()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto by_scene = table_of(folder_.read("scene-lrcs/sweep.csv")).rows;
  EXPECT_EQ(table_of(folder_.read("box-lrcs/sweep.csv")).rows, by_scene);
  EXPECT_EQ(by_scene.size(), 5U);
}

TEST_F(Sweep, ByFlagsTakesNegativeAnglesReceiversAndFacets) {
  const Outcome outcome =
      run_lrcs({"sweep",     "box.stl",   "--unit",      "mm",           "--material",       "metal-skin-5p",
                "--azimuth", "-20:20:20", "--elevation", "-30,30",       "--bistatic-angle", "-10",
                "--plane",   "elevation", "--facets",    "-20,30;0,-30", "--forward",        "y",
                "--up",      "-z",        "--sides",     "front",        "--repair",         "none",
                "-o",        "out"},
               {folder_.path()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json json = manifest();
  EXPECT_EQ(table().rows.size(), 6U);
  EXPECT_EQ(json["facets"][0]["row"], 3);
  EXPECT_EQ(json["facets"][1]["row"], 1);
  EXPECT_EQ(json["receiver"], Json({{"bistatic_angle_deg", -10.0}, {"plane", "elevation"}}));
  EXPECT_EQ(json["target"]["sides"], "front");
  EXPECT_EQ(json["target"]["repair"], "none");
  EXPECT_EQ(json["wavelength_m"], nullptr);
  EXPECT_EQ(table().comments.at(3), "# wavelength: not stated");
}

TEST_F(Sweep, WithoutADisplayLosesOnlyThePictureOfTheTarget) {
  ask_for("[{azimuth: 20, elevation: 0}]");
  const Outcome outcome = run_lrcs({"sweep", "scene.yaml", "-o", "out"},
                                   {.folder = folder_.path(), .environment = {{"DISPLAY", ""}, {"PATH", "/nowhere"}}});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.err.find("lrcs: warning: facets-0.png was not drawn: "), std::string::npos) << outcome.err;
  for (const char* file : {"sweep.csv", "sweep.png", "polar.png", "facets-0.vtp", "manifest.json"})
    EXPECT_TRUE(folder_.has(std::string("out/") + file)) << file;
  EXPECT_FALSE(folder_.has("out/facets-0.png"));
  EXPECT_EQ(manifest()["warnings"].size(), 1U);
}

TEST_F(Sweep, ThatCannotWriteEndsWithOneMessageAndLeavesNothingHalf) {
  ask_for("all");
  // A limit on the size of files stands for a full disk.
  const Outcome outcome =
      run_lrcs({"sweep", "scene.yaml", "-o", "out", "-q"}, {.folder = folder_.path(), .largest_file = 2000});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_NE(outcome.err.find("vtp: cannot be written: File too large\n"), std::string::npos) << outcome.err;
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path() / "out"));
}

}  // namespace
}  // namespace lrcs
