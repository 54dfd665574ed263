#pragma once
#include <filesystem>
#include <optional>
#include <string_view>

namespace lrcs {

enum class FileFormat { stl_text, stl_binary, obj, ply, off, step, iges, brep, gltf, three_mf, vtk_xml };

// Which of the formats that other libraries read a file has, by what it holds; none: another, or the file is not there.
[[nodiscard]] std::optional<FileFormat> foreign_format_of(const std::filesystem::path& file);

// Are there surfaces in such a file, of which facets must be made?
[[nodiscard]] bool holds_surfaces(FileFormat format);

// Does the file say in which unit its lengths are? True also of a file that is not there.
[[nodiscard]] bool has_unit(const std::filesystem::path& file);

// The axes of a file that are the nose and the upper side, where the user does not say: those of the format.
struct FileAxes {
  const char *forward = "+x", *up = "+z";
};
[[nodiscard]] FileAxes axes_of(const std::filesystem::path& file);

// The format of a file of facets, by what it holds; its extension decides only what content leaves open.
// error: InputError for an empty file, UTF-16, a known format that is not read (named), one of
// foreign_format_of(), and one that is not known.
[[nodiscard]] FileFormat file_format_of(std::string_view content, const std::filesystem::path& file);

// Number of facets that the header of a binary STL announces. domain: at least 84 bytes.
[[nodiscard]] std::uint32_t binary_stl_count(std::string_view content);

}  // namespace lrcs
