#pragma once
#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstdint>
#include <string>

namespace lrcs {

inline std::string base64(const std::string& bytes) {
  constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    unsigned value = 0;
    for (std::size_t j = 0; j < 3; ++j)
      value = value << 8U | (k + j < bytes.size() ? static_cast<unsigned char>(bytes[k + j]) : 0U);
    for (int j = 3; j >= 0; --j) text += letters[value >> (6U * static_cast<unsigned>(j)) & 63U];
  }
  if (bytes.size() % 3 > 0)
    text.replace(text.size() - (3 - bytes.size() % 3), 3, std::string(3 - bytes.size() % 3, '='));
  return text;
}

using GltfIndices = std::array<unsigned char, 12>;
inline constexpr GltfIndices tetra_indices{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

// Corners at 0 and the unit vectors, then the indices of four facets.
inline std::string gltf_data(const GltfIndices& indices) {
  std::string data;
  for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F}) {
    const auto raw = std::bit_cast<std::array<char, 4>>(x);
    data.append(raw.begin(), raw.end());
  }
  data.append(indices.begin(), indices.end());
  return data;
}

// place: of the buffer's data, as a further member of it.
inline std::string gltf_json(const std::string& nodes, const std::string& place) {
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [)" + nodes +
         R"(], "meshes": [{"name": "tetra", "primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
"materials": [{"name": "gold", "pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0, 1]}}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]},
 {"bufferView": 1, "componentType": 5121, "count": 12, "type": "SCALAR"}],
"bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
"buffers": [{"byteLength": 60)" +
         place + R"(}]})";
}

// glTF with one mesh, a tetrahedron with corners at 0 and the unit vectors, volume 1/6 m^3, of a material; `nodes` is
// the content of the list of nodes, the first of which is the root. indices: of the four facets.
inline std::string gltf_of(const std::string& nodes, const GltfIndices& indices = tetra_indices) {
  return gltf_json(nodes, R"(, "uri": "data:application/octet-stream;base64,)" + base64(gltf_data(indices)) + '"');
}

// The same as a binary file.
inline std::string glb_of(const std::string& nodes) {
  std::string json = gltf_json(nodes, "");
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string data = gltf_data(tetra_indices);
  const auto word = [](std::size_t value) {
    const auto raw = std::bit_cast<std::array<char, 4>>(static_cast<std::uint32_t>(value));
    return std::string(raw.begin(), raw.end());
  };
  return "glTF" + word(2) + word(28 + json.size() + data.size()) + word(json.size()) + "JSON" + json +
         word(data.size()) + std::string("BIN\0", 4) + data;
}

}  // namespace lrcs
