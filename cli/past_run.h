#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "lrcs/scene_target.h"
#include "lrcs/sweep.h"

namespace lrcs {

// The file of a result folder that says what was computed, as a scene file.
inline constexpr const char* scene_as_run = "scene-as-run.yaml";

// A sweep that is done: its scene, its target as it was read, its rows.
struct PastRun {
  Scene scene;
  LoadedTarget loaded;
  std::vector<SweepRow> rows;
  std::string csv;       // sweep.csv as it stands
  std::string manifest;  // manifest.json as it stands
};

// From a folder that `lrcs sweep` wrote. error: InputError where it holds no complete result, or where its target, or
// what else it was computed from, is no longer there or no longer the same.
[[nodiscard]] PastRun read_past_run(const std::filesystem::path& folder);

// Is this sigma, computed exactly once more, what the sweep found for the row? Of a sampled sweep nothing is asked.
[[nodiscard]] bool is_as_before(const PastRun& run, std::size_t row, const Estimate& sigma);

}  // namespace lrcs
