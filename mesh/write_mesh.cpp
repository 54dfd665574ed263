#include "mesh/write_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <iterator>

#include "base/input_error.h"
#include "base/whole_file.h"
#include "mesh/facet_lists.h"

namespace lrcs {
namespace {

std::string extension_of(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

// Names with a line end would end the line that they stand in.
std::string one_line(std::string name) {
  for (char& c : name)
    if (static_cast<unsigned char>(c) < 0x20U) c = ' ';
  return name;
}

std::string obj_text(const FacetMesh& mesh) {
  std::string text = "# written by lrcs\n";
  const auto out = std::back_inserter(text);
  for (const Vec3& p : mesh.positions) fmt::format_to(out, "v {} {} {}\n", p.x(), p.y(), p.z());
  const auto parts = facets_of_parts(mesh);
  for (std::size_t part = 0; part < parts.size(); ++part) {
    if (!mesh.part.names[part].empty()) fmt::format_to(out, "o {}\n", one_line(mesh.part.names[part]));
    std::uint32_t material = ~0U;
    for (const std::uint32_t k : parts[part]) {
      if (mesh.file_material.of[k] != material) {
        material = mesh.file_material.of[k];
        if (mesh.file_material.names.size() > 1 || !mesh.file_material.names[material].empty())
          fmt::format_to(out, "usemtl {}\n", one_line(mesh.file_material.names[material]));
      }
      const auto& [a, b, c] = mesh.facets[k];
      fmt::format_to(out, "f {} {} {}\n", a + 1, b + 1, c + 1);
    }
  }
  return text;
}

std::string off_text(const FacetMesh& mesh) {
  std::string text = fmt::format("OFF\n{} {} 0\n", mesh.positions.size(), mesh.size());
  const auto out = std::back_inserter(text);
  for (const Vec3& p : mesh.positions) fmt::format_to(out, "{} {} {}\n", p.x(), p.y(), p.z());
  for (const auto& [a, b, c] : mesh.facets) fmt::format_to(out, "3 {} {} {}\n", a, b, c);
  return text;
}

template <class Number>
void append_little_endian(std::string& bytes, Number number) {
  auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

std::string ply_bytes(const FacetMesh& mesh) {
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment written by lrcs\nelement vertex {}\nproperty double x\nproperty "
      "double y\nproperty double z\nelement face {}\nproperty list uchar uint vertex_indices\nend_header\n",
      mesh.positions.size(), mesh.size());
  for (const Vec3& p : mesh.positions)
    for (const double x : p) append_little_endian(bytes, x);
  for (const auto& facet : mesh.facets) {
    bytes += '\3';
    for (const std::uint32_t corner : facet) append_little_endian(bytes, corner);
  }
  return bytes;
}

void append_vector(std::string& bytes, const Vec3& v) {
  for (const double x : v) append_little_endian(bytes, static_cast<float>(x));
}

std::string stl_bytes(const FacetMesh& mesh) {
  std::string bytes = "written by lrcs";
  bytes.resize(80, ' ');
  append_little_endian(bytes, static_cast<std::uint32_t>(mesh.size()));
  for (std::size_t k = 0; k < mesh.size(); ++k) {
    append_vector(bytes, mesh.normals[k]);
    for (const Vec3& corner : mesh.corners(k)) append_vector(bytes, corner);
    bytes.append(2, '\0');
  }
  return bytes;
}

using Text = std::string (*)(const FacetMesh&);

Text text_of(const std::string& extension) {
  constexpr std::array<Text, 4> texts{obj_text, ply_bytes, off_text, stl_bytes};
  const auto& known = mesh_extensions();
  const auto found = std::find(known.begin(), known.end(), extension);
  return found == known.end() ? nullptr : texts[static_cast<std::size_t>(found - known.begin())];
}

}  // namespace

const std::vector<std::string>& mesh_extensions() {
  static const std::vector<std::string> extensions{".obj", ".ply", ".off", ".stl"};
  return extensions;
}

bool writes_mesh(const std::filesystem::path& file) {
  return text_of(extension_of(file)) != nullptr;
}

void write_mesh(const std::filesystem::path& file, const FacetMesh& mesh) {
  const Text text = text_of(extension_of(file));
  if (text == nullptr)
    throw InputError(Place{file.string()},
                     fmt::format("expected a name that ends in one of {}", fmt::join(mesh_extensions(), ", ")));
  write_whole_file(file, text(mesh));
}

}  // namespace lrcs
