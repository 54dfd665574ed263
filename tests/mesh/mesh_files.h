#pragma once
#include <fmt/format.h>

#include <array>
#include <bit>
#include <string>
#include <vector>

#include "made_meshes.h"

namespace lrcs {

// Little writers of the formats that read_mesh() reads.

inline std::string text_stl(const FacetMesh& mesh, const std::string& name = "made") {
  std::string text = "solid " + name + "\n";
  for (std::size_t k = 0; k < mesh.size(); ++k) {
    text += " facet normal 0 0 0\n  outer loop\n";
    for (const Vec3& p : mesh.corners(k)) text += fmt::format("   vertex {} {} {}\n", p.x(), p.y(), p.z());
    text += "  endloop\n endfacet\n";
  }
  return text + "endsolid " + name + "\n";
}

// The bytes of a value, in the byte order asked for.
template <class T>
std::string bytes_of(T value, bool big_endian = false) {
  const auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  std::string bytes(raw.begin(), raw.end());
  return big_endian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

inline std::string binary_stl(const FacetMesh& mesh, std::string header = "binary") {
  header.resize(80, '\0');
  std::string bytes = header + bytes_of(static_cast<std::uint32_t>(mesh.size()));
  for (std::size_t k = 0; k < mesh.size(); ++k) {
    bytes += std::string(12, '\0');
    for (const Vec3& p : mesh.corners(k)) {
      for (const double x : p) bytes += bytes_of(static_cast<float>(x));
    }
    bytes += std::string(2, '\0');
  }
  return bytes;
}

inline std::string obj(const FacetMesh& mesh) {
  std::string text = "# made\n";
  for (const Vec3& p : mesh.positions) text += fmt::format("v {} {} {}\n", p.x(), p.y(), p.z());
  for (const auto& f : mesh.facets) text += fmt::format("f {} {} {}\n", f[0] + 1, f[1] + 1, f[2] + 1);
  return text;
}

inline std::string off(const FacetMesh& mesh) {
  std::string text = fmt::format("OFF\n{} {} 0\n", mesh.positions.size(), mesh.size());
  for (const Vec3& p : mesh.positions) text += fmt::format("{} {} {}\n", p.x(), p.y(), p.z());
  for (const auto& f : mesh.facets) text += fmt::format("3 {} {} {}\n", f[0], f[1], f[2]);
  return text;
}

inline std::string ply(const FacetMesh& mesh, const std::string& encoding) {
  std::string text = fmt::format(
      "ply\nformat {} 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      encoding, mesh.positions.size(), mesh.size());
  const bool is_text = encoding == "ascii";
  const bool big = encoding == "binary_big_endian";
  for (const Vec3& p : mesh.positions) {
    for (const double x : p) text += is_text ? fmt::format("{} ", x) : bytes_of(x, big);
    if (is_text) text += "\n";
  }
  for (const auto& f : mesh.facets) {
    text += is_text ? "3" : "\x03";
    for (const std::uint32_t index : f) text += is_text ? fmt::format(" {}", index) : bytes_of(index, big);
    if (is_text) text += "\n";
  }
  return text;
}

// The mesh as a file of every format. Coordinates must be floats.
inline std::vector<std::string> every_format(const FacetMesh& mesh) {
  return {text_stl(mesh),
          binary_stl(mesh),
          obj(mesh),
          off(mesh),
          ply(mesh, "ascii"),
          ply(mesh, "binary_little_endian"),
          ply(mesh, "binary_big_endian")};
}

}  // namespace lrcs
