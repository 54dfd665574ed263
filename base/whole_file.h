#pragma once
#include <filesystem>
#include <string_view>

namespace lrcs {

// Writes a file that appears whole or not at all: the content goes to disk without a name, then gets the final one.
// laws: kill the program at any moment: the final name holds the old content or the new, and no half-written file lies
//   beside it (on file systems without nameless files a hidden ".<name>.<process>.part" may).
// error: std::runtime_error where it cannot be written.
void write_whole_file(const std::filesystem::path& file, std::string_view content);

}  // namespace lrcs
