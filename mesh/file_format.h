#pragma once
#include <filesystem>
#include <optional>
#include <string_view>

namespace lrcs {

enum class FileFormat { stl_text, stl_binary, obj, ply, off, step, iges, brep };

// Which format of surfaces, not of facets, a file holds, by how it begins; none: it holds no CAD, or is not there.
[[nodiscard]] std::optional<FileFormat> cad_format_of(const std::filesystem::path& file);

// Does its format say in which unit its lengths are?
[[nodiscard]] bool has_unit(const std::filesystem::path& file);

// The format of a file of facets, by what it holds; its extension decides only what content leaves open.
// error: InputError for an empty file, UTF-16, a known format that is not read (named), CAD, and one that is not known.
[[nodiscard]] FileFormat file_format_of(std::string_view content, const std::filesystem::path& file);

// Number of facets that the header of a binary STL announces. domain: at least 84 bytes.
[[nodiscard]] std::uint32_t binary_stl_count(std::string_view content);

}  // namespace lrcs
