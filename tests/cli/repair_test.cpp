#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "program.h"

namespace lrcs {
namespace {

// A box of two OBJ parts: walls facing inward without lid, and the lid a hair above them; beside it a sheet of two
// facets of opposite windings.
constexpr const char* leaky = R"(v 0 0 0
v 1 0 0
v 0 1 0
v 1 1 0
v 0 0 1
v 1 0 1
v 0 1 1
v 1 1 1
v 0 0 1.0000001
v 1 0 1.0000001
v 0 1 1.0000001
v 1 1 1.0000001
v 3 0 0
v 4 0 0
v 4 1 0
v 3 1 0
o walls
usemtl steel
f 1 2 4 3
f 1 5 6 2
f 4 8 7 3
f 1 3 7 5
f 2 6 8 4
o lid
usemtl gold
f 9 11 12 10
o sheet
f 13 14 15
f 13 16 15
)";

nlohmann::json info_of(const ScratchFolder& folder, const std::string& file) {
  const Outcome outcome = run_lrcs({"info", file, "--unit", "m", "--json"}, {folder.path()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return nlohmann::json::parse(outcome.out);
}

TEST(Repair, ClosesGapsTurnsAndKeepsParts) {
  const ScratchFolder folder;
  folder.write("leaky.obj", leaky);
  EXPECT_FALSE(info_of(folder, "leaky.obj")["closed"].get<bool>());
  for (const std::string out : {"mended.obj", "mended.vtp"}) {
    const Outcome outcome = run_lrcs({"repair", "leaky.obj", "-o", out}, {folder.path()});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("4 near ones"), std::string::npos) << outcome.out;
    const auto info = info_of(folder, out);
    EXPECT_EQ(info["parts"].size(), 3U);
    EXPECT_EQ(info["parts"][1]["name"], "lid");
    EXPECT_NEAR(info["volume_m3"].get<double>(), 1.0, 1e-6);
    EXPECT_EQ(info["diagnosis"]["flipped"], 0);
    EXPECT_EQ(info["diagnosis"]["against_most"], 0);
    EXPECT_EQ(info["diagnosis"]["boundary_edges"], 4);
    EXPECT_EQ(info["parts"][0]["material"], out == "mended.obj" ? nlohmann::json("steel") : nlohmann::json());
  }
}

TEST(Repair, LeavesGapsOpenWithoutTolerance) {
  const ScratchFolder folder;
  folder.write("leaky.obj", leaky);
  const Outcome outcome =
      run_lrcs({"repair", "leaky.obj", "-o", "still.ply", "--tolerance", "0", "-q"}, {folder.path()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out + outcome.err, "");
  EXPECT_FALSE(info_of(folder, "still.ply")["closed"].get<bool>());
}

TEST(Repair, FillsHolesIfAsked) {
  const ScratchFolder folder;
  folder.write("leaky.obj", leaky);
  const Outcome outcome =
      run_lrcs({"repair", "leaky.obj", "-o", "filled.stl", "--tolerance", "1 nm", "--unit", "m", "--fill-holes"},
               {folder.path()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("3 holes"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.err.find("holds no parts"), std::string::npos) << outcome.err;
}

TEST(Repair, SaysWhatIsWrongWithItsWords) {
  const ScratchFolder folder;
  folder.write("leaky.obj", leaky);
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"-o", "x.step"}, "x.step: expected a name that ends in one of .obj, .ply, .off, .stl, .vtp"},
      {{"-o", "x.obj", "--tolerance", "2"}, "--tolerance: expected 0..0.1 of the diagonal"},
      {{"-o", "x.obj", "--tolerance", "1 mm"},
       "--tolerance: expected a fraction of the target's size, or a length and"},
      {{"-o", "x.obj", "--tolerance", "1 q"}, "--tolerance: "},
      {{"-o", "x.obj", "--fill-holes", "many"}, "--fill-holes"},
      {{"-o", "x.obj", "--unit", "q"}, "--unit: unknown length unit 'q'"},
      {{"-o", "none/x.obj"}, "--output: no such folder: 'none'"},
      {{}, "--output is required"}};
  for (const auto& [words, complaint] : cases) {
    std::vector<std::string> all{"repair", "leaky.obj"};
    all.insert(all.end(), words.begin(), words.end());
    const Outcome outcome = run_lrcs(all, {folder.path()});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find(complaint), std::string::npos) << outcome.err;
    EXPECT_FALSE(folder.has("x.obj"));
  }
}

}  // namespace
}  // namespace lrcs
