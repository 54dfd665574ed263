// A sweep that is killed leaves whole files only, and a manifest only of a complete result.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/cli/made_scene.h"
#include "tests/cli/program.h"

namespace lrcs {
namespace {

constexpr int directions = 21;

bool is_whole(const std::filesystem::path& file) {
  const std::string content = content_of(file);
  const std::string kind = file.extension();
  if (kind == ".vtp") return content.ends_with("</VTKFile>\n");
  if (kind == ".h5") return content.starts_with("\x89HDF") && content.size() > 10000;
  if (kind == ".yaml") return content.ends_with("output: {facets: all}\n");
  if (kind == ".pvd") return content.ends_with("</VTKFile>\n");
  if (kind == ".json") return nlohmann::json::accept(content);
  if (kind == ".png") return content.ends_with(std::string("IEND\xae\x42\x60\x82"));
  const auto lines = std::count(content.begin(), content.end(), '\n');
  const auto comments = std::count(content.begin(), content.end(), '#');
  return kind == ".csv" && content.ends_with('\n') && lines == comments + 1 + directions;
}

TEST(KilledSweep, LeavesWholeFilesOnly) {
  const ScratchFolder folder;
  folder.write("box.stl", stl_sphere(7));
  std::string text = scene_with("step: 10", "step: 2") + "output: {facets: all}\n";
  text.replace(text.find("panel*"), 6, "b*");
  folder.write("scene.yaml", text);
  const std::vector<std::string> words{"sweep", "scene.yaml", "-o", "out", "-q", "--hdf5"};
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(run_lrcs(words, {folder.path()}).status, 0);
  const auto whole_run =
      std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - start);

  std::mt19937 random(20260101);
  std::uniform_int_distribution<int> delay_ms(0, static_cast<int>(whole_run.count()));
  int killed = 0, with_files = 0;
  // A run may end before its delay on a machine that got less busy: then there is another.
  for (int attempt = 0; attempt < 200 && (killed < 12 || with_files < 5); ++attempt) {
    const Outcome outcome = run_lrcs(words, {.folder = folder.path(), .kill_after_ms = delay_ms(random)});
    killed += outcome.status == -SIGKILL ? 1 : 0;
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "out")) {
      const std::string name = entry.path().filename();
      if (name.starts_with('.')) continue;  // the temporary name of a file not yet whole
      EXPECT_TRUE(is_whole(entry.path())) << name;
      ++files;
    }
    with_files += files > 0 ? 1 : 0;
    if (folder.has("out/manifest.json")) {
      const auto manifest = nlohmann::json::parse(folder.read("out/manifest.json"));
      for (const auto& output : manifest["outputs"])
        EXPECT_TRUE(folder.has("out/" + output["file"].get<std::string>())) << output["file"];
      EXPECT_EQ(manifest["facets"].size(), static_cast<std::size_t>(directions));
    }
    std::filesystem::remove_all(folder.path() / "out");
    std::filesystem::create_directory(folder.path() / "out");
  }
  EXPECT_GE(killed, 10) << "the delays should fall within the run of " << whole_run.count() << " ms";
  EXPECT_GE(with_files, 5);
}

}  // namespace
}  // namespace lrcs
