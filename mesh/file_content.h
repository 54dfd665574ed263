#pragma once
#include <filesystem>
#include <string>

namespace lrcs {

// The content of a file that perhaps is compressed by gzip: unpacked, without UTF-8's byte order mark.
// error: InputError that names the file: none, a folder, no regular file, damaged gzip.
[[nodiscard]] std::string plain_content(const std::filesystem::path& file);

}  // namespace lrcs
