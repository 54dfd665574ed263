// `lrcs report`; what the page does in a browser is tested in report/web/test.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/made_scene.h"
#include "tests/cli/program.h"

namespace lrcs {
namespace {

using testing::HasSubstr;

class Report : public testing::Test {
 protected:
  Report() {
    folder_.write("box.stl", two_boxes());
    folder_.write("scene.yaml", good_scene + "receiver: {bistatic_angle: 5}\n");
    EXPECT_EQ(run_lrcs({"sweep", "scene.yaml", "-o", "out"}, {folder_.path()}).status, 0);
  }
  [[nodiscard]] nlohmann::json numbers(const std::string& file) const {
    const std::string page = folder_.read(file), begin = R"(id="lrcs-data">)";
    const auto from = page.find(begin) + begin.size();
    return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
  }
  ScratchFolder folder_;
};

TEST_F(Report, HoldsTheSweepItsPartsAndItsTarget) {
  const Outcome made = run_lrcs({"report", "out"}, {folder_.path()});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(made.err, HasSubstr("report of 5 rows, 24 facets shown"));
  const nlohmann::json json = numbers("out/report.html");
  EXPECT_EQ(json.at("csv"), folder_.read("out/sweep.csv"));
  EXPECT_EQ(json.at("title"), "Bistatic LRCS of box.stl");
  EXPECT_EQ(json.at("run").at("receiver"), "bistatic angle 5° in azimuth");
  EXPECT_EQ(json.at("target").at("box_m").dump(), "[[-1.0,-0.5,-0.5],[1.0,2.0,0.5]]");
  EXPECT_EQ(json.at("cuts").at(0).at("rows").dump(), "[0,1,2,3,4]");
  ASSERT_EQ(json.at("parts").size(), 2U);
  for (std::size_t row = 0; row < 5; ++row) {
    const double sigma = json.at("rows").at("sigma_m2").at(row);
    const auto& parts = json.at("part_sigma_m2").at(row);
    EXPECT_NEAR(parts.at(0).get<double>() + parts.at(1).get<double>(), sigma, 1e-12 * sigma);
    EXPECT_GT(parts.at(1).get<double>(), 0.0);
  }
}

TEST_F(Report, IsTheSameForAnyNumberOfThreads) {
  ASSERT_EQ(run_lrcs({"report", "out", "-o", "a.html", "-t", "1"}, {folder_.path()}).status, 0);
  ASSERT_EQ(run_lrcs({"report", "out", "-o", "b.html", "-t", "4"}, {folder_.path()}).status, 0);
  EXPECT_EQ(folder_.read("a.html"), folder_.read("b.html"));
}

TEST_F(Report, RefusesWhatIsNoResultAnyMore) {
  const std::string manifest = folder_.read("out/manifest.json");
  const auto refused = [&](const std::string& file, const std::string& what) {
    const Outcome outcome = run_lrcs({"report", "out"}, {folder_.path()});
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(file + ": " + what));
    EXPECT_FALSE(folder_.has("out/report.html"));
    folder_.write("out/manifest.json", manifest);
  };
  for (const auto& [key, other] :
       std::vector<std::pair<std::string, std::string>>{{"\"command\":", "\"commands\":"},
                                                        {"\"skipped\":", "\"skipped\": 3, \"b\":"},
                                                        {"\"warnings\":", "\"warnings\": \"hello\", \"c\":"},
                                                        {"\"outputs\":", "\"outputs\": [], \"d\":"}}) {
    std::string edited = manifest;
    folder_.write("out/manifest.json", edited.replace(edited.find(key), key.size(), other));
    refused("out/manifest.json", key == "\"outputs\":" ? "knows of no sweep.csv" : "expected the manifest of a sweep");
  }
  folder_.write("out/manifest.json", manifest.substr(0, 500));
  refused("out/manifest.json", "expected the manifest");
  folder_.write("out/sweep.csv", folder_.read("out/sweep.csv") + "#\n");
  refused("out/sweep.csv", "has changed since the sweep");
  EXPECT_EQ(run_lrcs({"report", "scene.yaml"}, {folder_.path()}).status, 2);
}

TEST_F(Report, HoldsEveryRowWhereDirectionsRepeat) {
  folder_.write("scene.yaml", good_scene.substr(0, good_scene.find("sweep:")) + "sweep: {azimuth: [0, 30, 0]}\n");
  ASSERT_EQ(run_lrcs({"sweep", "scene.yaml", "-o", "out"}, {folder_.path()}).status, 0);
  ASSERT_EQ(run_lrcs({"report", "out"}, {folder_.path()}).status, 0);
  const nlohmann::json json = numbers("out/report.html");
  EXPECT_EQ(json.at("axis"), "row");
  EXPECT_EQ(json.at("cuts").at(0).at("rows").dump(), "[0,1,2]");
}

}  // namespace
}  // namespace lrcs
