#include "bench/written_mesh.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <iterator>
#include <string>

#include "base/whole_file.h"
#include "mesh/write_mesh.h"

namespace lrcs {
namespace {

void append_bits(std::uint32_t bits, std::string& bytes) {
  for (int byte = 0; byte < 4; ++byte, bits >>= 8U) bytes += static_cast<char>(bits & 0xffU);
}

void append_floats(const Vec3& v, std::string& bytes) {
  for (const double x : v) append_bits(std::bit_cast<std::uint32_t>(static_cast<float>(x)), bytes);
}

void append_text(const char* before, const Vec3& v, std::string& text) {
  const Eigen::Vector3f p = v.cast<float>();
  fmt::format_to(std::back_inserter(text), "{}{} {} {}\n", before, p.x(), p.y(), p.z());
}

void append_text_stl(const FacetMesh& mesh, std::string& text) {
  text += "solid target\n";
  for (std::size_t k = 0; k < mesh.size(); ++k) {
    append_text("facet normal ", mesh.normals[k], text);
    text += "outer loop\n";
    for (const Vec3& corner : mesh.corners(k)) append_text("vertex ", corner, text);
    text += "endloop\nendfacet\n";
  }
  text += "endsolid target\n";
}

std::string ply_header(const char* encoding, const FacetMesh& mesh) {
  return fmt::format(
      "ply\nformat {} 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      encoding, mesh.positions.size(), mesh.size());
}

void append_binary_ply(const FacetMesh& mesh, std::string& bytes) {
  bytes += ply_header("binary_little_endian", mesh);
  for (const Vec3& p : mesh.positions) append_floats(p, bytes);
  for (const auto& facet : mesh.facets) {
    bytes += '\3';
    for (const std::uint32_t corner : facet) append_bits(corner, bytes);
  }
}

void append_text_ply(const FacetMesh& mesh, std::string& text) {
  text += ply_header("ascii", mesh);
  for (const Vec3& p : mesh.positions) append_text("", p, text);
  for (const auto& [a, b, c] : mesh.facets) fmt::format_to(std::back_inserter(text), "3 {} {} {}\n", a, b, c);
}

template <void (*append)(const FacetMesh&, std::string&)>
void write(const std::filesystem::path& file, const FacetMesh& mesh) {
  std::string bytes;
  append(mesh, bytes);
  write_whole_file(file, bytes);
}

constexpr std::array formats{WrittenFormat{"STL, binary", ".stl", write_mesh},
                             WrittenFormat{"STL, text", ".stl", write<append_text_stl>},
                             WrittenFormat{"PLY, binary", ".ply", write<append_binary_ply>},
                             WrittenFormat{"PLY, text", ".ply", write<append_text_ply>}};

}  // namespace

std::span<const WrittenFormat> written_formats() {
  return formats;
}

}  // namespace lrcs
