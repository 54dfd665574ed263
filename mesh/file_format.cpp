#include "mesh/file_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <fstream>
#include <optional>
#include <string>
#include <utility>

#include "base/digest.h"
#include "base/input_error.h"
#include "base/text_scanner.h"

namespace lrcs {
namespace {

constexpr std::string_view readable = "expected STEP, IGES, BREP, glTF, 3MF, VTP, VTU, STL, OBJ, PLY or OFF";

struct Signature {
  std::string_view begin;
  std::string_view name;
};

constexpr std::array unread_formats{
    Signature{"BZh", "compressed (bzip2)"},
    Signature{"\xfd"
              "7zXZ",
              "compressed (xz)"},
    Signature{"# vtk DataFile", "a VTK legacy file"},
    Signature{"<VTKFile", "a VTK XML file"},
    Signature{"<?xml", "an XML file (such as COLLADA, AMF or X3D)"},
    Signature{"#VRML", "a VRML file"},
    Signature{"Kaydara FBX", "an FBX file"},
    Signature{"$MeshFormat", "a Gmsh file"},
    Signature{"\x89HDF", "an HDF5 file"},
    Signature{"%PDF", "a PDF document"},
};

bool is_iges(std::string_view content) {
  return content.size() > 80 && (content[72] == 'S' || content[72] == 'C') &&
         content.substr(73, 7).find_first_not_of(" 0123456789") == std::string_view::npos;
}

bool is_vtk_surface(std::string_view head) {
  const std::size_t begin = head.find("<VTKFile");
  if (begin == std::string_view::npos || head.front() != '<') return false;
  const std::string_view tag = head.substr(begin, head.find('>', begin) - begin);
  return tag.find("\"PolyData\"") != std::string_view::npos ||
         tag.find("\"UnstructuredGrid\"") != std::string_view::npos;
}

constexpr std::string_view zip = "PK\x03\x04";

std::optional<FileFormat> foreign_format(std::string_view content) {
  if (is_iges(content)) return FileFormat::iges;
  while (!content.empty() && std::isspace(static_cast<unsigned char>(content.front())) != 0) content.remove_prefix(1);
  if (content.starts_with("ISO-10303-21")) return FileFormat::step;
  if (content.starts_with("glTF")) return FileFormat::gltf;
  if (is_vtk_surface(content.substr(0, 1024))) return FileFormat::vtk_xml;
  if (content.starts_with("{") && content.find("\"asset\"") != std::string_view::npos) return FileFormat::gltf;
  if (content.starts_with(zip) && content.find("3D/") != std::string_view::npos) return FileFormat::three_mf;
  if (content.starts_with("DBRep_DrawableShape") || content.starts_with("CASCADE Topology")) return FileFormat::brep;
  return std::nullopt;
}

void refuse_unread(std::string_view content, const std::string& file) {
  const auto refuse = [&](std::string_view name) {
    throw InputError(Place{file}, fmt::format("is {}, which is not read yet; {}", name, readable));
  };
  for (const Signature& format : unread_formats) {
    if (content.starts_with(format.begin)) refuse(format.name);
  }
  if (content.starts_with("\xfe\xff") || content.starts_with("\xff\xfe"))
    throw InputError(Place{file}, "is UTF-16 text, expected UTF-8 or ASCII");
}

// The size of a binary STL fits its header; no text has such a count there.
bool is_binary_stl(std::string_view content) {
  return content.size() >= 84 && content.size() == 84 + std::size_t{50} * binary_stl_count(content);
}

bool is_text(std::string_view content) {
  return content.substr(0, 4096).find('\0') == std::string_view::npos;
}

bool is_off_keyword(std::string_view word) {
  for (const std::string_view prefix : {"ST", "C", "N", "4", "n"}) {
    if (word.starts_with(prefix)) word.remove_prefix(prefix.size());
  }
  return word == "OFF";
}

bool is_obj_keyword(std::string_view word) {
  constexpr std::array keywords{"v", "vt", "vn", "vp", "f", "o", "g", "s", "l", "p", "mtllib", "usemtl", "fo"};
  return std::find(keywords.begin(), keywords.end(), word) != keywords.end();
}

std::optional<FileFormat> text_format(std::string_view content) {
  TextScanner scanner(content, "");
  const std::string_view word = scanner.next_word();
  if (word == "ply") return FileFormat::ply;
  if (is_off_keyword(word)) return FileFormat::off;
  if (same_word(word, "solid") || same_word(word, "facet")) return FileFormat::stl_text;
  if (is_obj_keyword(word)) return FileFormat::obj;
  return std::nullopt;
}

std::optional<FileFormat> format_by_extension(const std::filesystem::path& file, bool text) {
  const std::string extension = (file.extension() == ".gz" ? file.stem() : file).extension().string();
  if (same_word(extension, ".stl")) return text ? FileFormat::stl_text : FileFormat::stl_binary;
  if (!text) return std::nullopt;
  if (same_word(extension, ".obj")) return FileFormat::obj;
  if (same_word(extension, ".ply")) return FileFormat::ply;
  if (same_word(extension, ".off")) return FileFormat::off;
  return std::nullopt;
}

}  // namespace

std::uint32_t binary_stl_count(std::string_view content) {
  std::uint32_t count = 0;
  for (std::size_t k = 4; k-- > 0;) count = count << 8U | static_cast<unsigned char>(content[80 + k]);
  return count;
}

std::optional<FileFormat> foreign_format_of(const std::filesystem::path& file) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none)) return std::nullopt;
  std::array<char, 1024> head{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(head.data(), head.size());
  std::string content(head.data(), static_cast<std::size_t>(stream.gcount()));
  // What tells these two may stand anywhere.
  if (content.starts_with("{") || content.starts_with(zip)) content = content_of_file(file);
  std::string_view rest = content;
  if (rest.starts_with("\xef\xbb\xbf")) rest.remove_prefix(3);
  return foreign_format(rest);
}

bool holds_surfaces(FileFormat format) {
  return format == FileFormat::step || format == FileFormat::iges || format == FileFormat::brep;
}

bool has_unit(const std::filesystem::path& file) {
  std::error_code none;
  if (!std::filesystem::exists(file, none)) return true;  // who reads it says what is wrong
  const auto format = foreign_format_of(file);
  return format && *format != FileFormat::brep && *format != FileFormat::vtk_xml;
}

FileAxes axes_of(const std::filesystem::path& file) {
  return foreign_format_of(file) == FileFormat::gltf ? FileAxes{"+z", "+y"} : FileAxes{};
}

FileFormat file_format_of(std::string_view content, const std::filesystem::path& file) {
  if (content.empty()) throw InputError(Place{file.string()}, fmt::format("is empty, {}", readable));
  if (is_binary_stl(content)) return FileFormat::stl_binary;
  if (foreign_format(content))
    throw InputError(Place{file.string()},
                     "is STEP, IGES, BREP, glTF, 3MF, VTP or VTU, expected STL, OBJ, PLY or OFF here");
  refuse_unread(content, file.string());
  // A PLY header is text, its data need not be; a "solid" with zero bytes in it is a broken binary STL.
  const bool text = is_text(content);
  const auto by_content = text_format(content);
  if (by_content && (text || *by_content == FileFormat::ply)) return *by_content;
  if (by_content == FileFormat::stl_text) return FileFormat::stl_binary;
  if (const auto by_extension = format_by_extension(file, text)) return *by_extension;
  throw InputError(Place{file.string()}, fmt::format("is in no format known here, {}", readable));
}

}  // namespace lrcs
