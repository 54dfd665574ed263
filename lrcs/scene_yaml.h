#pragma once
#include <filesystem>
#include <string>

#include "lrcs/scene.h"

namespace lrcs {

// The scene as the text of a scene file in a folder: every key said, files by their paths from there.
// law: read_scene of that file gives a scene with the same results, to the last bit; as long as its files are there.
[[nodiscard]] std::string scene_to_yaml(const Scene& scene, const std::filesystem::path& folder);

}  // namespace lrcs
