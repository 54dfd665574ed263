#pragma once
#include <filesystem>
#include <string>

namespace lrcs {

// A file's path as it is to be said in a file that lies in a folder: relative to it, links resolved; absolute where
// either does not exist.
[[nodiscard]] std::string path_from(const std::filesystem::path& folder, const std::filesystem::path& file);

}  // namespace lrcs
