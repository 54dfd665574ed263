#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cli/made_scene.h"

namespace lrcs {
namespace {

// f_r = 0.25 / sr, at theta up to 60 deg.
std::string measured_grey() {
  std::string csv = "# wavelength: 1.06 um\n# azimuth_of_specular: 180\n# value: brdf\n";
  csv += "theta_i_deg,theta_r_deg,phi_deg,f_r_per_sr\n";
  for (const int i : {0, 20, 40, 60})
    for (const int r : {0, 20, 40, 60})
      for (const int phi : {0, 60, 120, 180})
        csv += std::to_string(i) + "," + std::to_string(r) + "," + std::to_string(phi) + ",0.25\n";
  return csv;
}

ScratchFolder& with_scene(ScratchFolder& folder, const std::string& outside) {
  folder.write("box.stl", two_boxes());
  folder.write("grey.csv", measured_grey());
  folder.write("scene.yaml", scene_with("{model: lambert, reflectance: 0.8}",
                                        "{model: tabulated, file: grey.csv, outside: " + outside + "}"));
  return folder;
}

TEST(TabulatedScene, IsSweptAndRecorded) {
  ScratchFolder folder;
  with_scene(folder, "nearest");
  const Outcome outcome = run_lrcs({"sweep", "scene.yaml", "-o", "out"}, {folder.path()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::string manifest = folder.read("out/manifest.json");
  for (const char* words : {"\"measurement\"", "\"file\": \"grey.csv\"", "\"outside\": \"nearest\"", "reciprocal"})
    EXPECT_NE(manifest.find(words), std::string::npos) << words << manifest;
}

TEST(TabulatedScene, NeverAsksForFacetsSeenEdgeOn) {
  ScratchFolder folder;
  with_scene(folder, "error");
  const Outcome outcome =
      run_lrcs({"sweep", "box.stl", "--unit", "m", "--material", "grey.yaml", "--azimuth", "0,90", "-o", "out"},
               {folder.path()});
  EXPECT_EQ(outcome.status, 2);  // no such material
  folder.write("grey.yaml", "{model: tabulated, file: grey.csv}\n");
  const Outcome again =
      run_lrcs({"sweep", "box.stl", "--unit", "m", "--material", "grey.yaml", "--azimuth", "0,90", "-o", "out"},
               {folder.path()});
  EXPECT_EQ(again.status, 0) << again.err;
}

TEST(TabulatedScene, ThatAsksForWhatWasNotMeasuredIsExitTwoWithOneMessageAndNoTable) {
  ScratchFolder folder;
  with_scene(folder, "error");
  folder.write("ball.stl", stl_sphere(12));
  folder.write("grey.yaml", "{model: tabulated, file: grey.csv}\n");
  for (const char* target : {"ball.stl", "box.stl"}) {
    const Outcome outcome = run_lrcs({"sweep", target, "--unit", "m", "--material", "grey.yaml", "--azimuth", "7:67:5",
                                      "--facets", "7,0", "-q", "-t", "4", "-o", "out"},
                                     {folder.path()});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err.find("lrcs: grey.csv: f_r was not measured at theta_i = "), 0U) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_FALSE(folder.has("out/sweep.csv"));
    EXPECT_FALSE(folder.has("out/manifest.json"));
  }
}

TEST(TabulatedMaterial, HasATableOfWhatWasMeasured) {
  ScratchFolder folder;
  with_scene(folder, "error");
  folder.write("grey.yaml", "{model: tabulated, file: grey.csv}\n");
  const Outcome outcome = run_lrcs({"brdf", "grey.yaml", "--theta-i", "20", "-o", "f.png"}, {folder.path()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\n20,-20,0,0.25,1\n"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("# not measured, left out: theta_i = 20 deg, theta_r = -80 "), std::string::npos);
  EXPECT_NE(outcome.err.find("lrcs: warning: not all directions were measured"), std::string::npos);
  EXPECT_EQ(folder.read("f.png").substr(1, 3), "PNG");
}

TEST(TabulatedMaterial, IsDrawnInEveryPictureAskedForOrInNone) {
  ScratchFolder folder;
  with_scene(folder, "error");
  folder.write("grey.yaml", "{model: tabulated, file: grey.csv}\n");
  const Outcome outcome =
      run_lrcs({"brdf", "grey.yaml", "--theta-i", "20", "-o", "f.png", "--surface", "s.png"}, {folder.path()});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("f_r was not measured at theta_i = "), std::string::npos) << outcome.err;
  EXPECT_FALSE(folder.has("f.png"));
  EXPECT_FALSE(folder.has("s.png"));
}

TEST(TabulatedMaterial, WarnsOfWhatTheMeasurementWarnsOf) {
  ScratchFolder folder;
  with_scene(folder, "nearest");
  folder.write("grey.csv",
               "# azimuth_of_specular: 180\n# value: brdf\ntheta_i_deg,theta_r_deg,phi_deg,f_r_per_sr\n"
               "10,0,0,0.25\n10,20,0,0.25\n10,40,0,0.25\n");
  const std::string warning = "lrcs: warning: material 'white': only one angle of incidence";
  EXPECT_NE(run_lrcs({"check", "scene.yaml"}, {folder.path()}).err.find(warning), std::string::npos);
  EXPECT_NE(run_lrcs({"sweep", "scene.yaml"}, {folder.path()}).err.find(warning), std::string::npos);
}

}  // namespace
}  // namespace lrcs
