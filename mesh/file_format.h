#pragma once
#include <filesystem>
#include <string_view>

namespace lrcs {

enum class FileFormat { stl_text, stl_binary, obj, ply, off };

// The format of a target file, by what it holds; its extension decides only what content leaves open.
// error: InputError for an empty file, UTF-16, a known format that is not read (named), and one that is not known.
[[nodiscard]] FileFormat file_format_of(std::string_view content, const std::filesystem::path& file);

// Number of facets that the header of a binary STL announces. domain: at least 84 bytes.
[[nodiscard]] std::uint32_t binary_stl_count(std::string_view content);

}  // namespace lrcs
