#pragma once
#include <stdlib.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "base/input_error.h"
#include "mesh/facet_mesh.h"
#include "mesh/read_mesh.h"

namespace lrcs {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

// A mesh of one part "" and one material "".
inline FacetMesh mesh_of(std::vector<Vec3> positions, Triangles facets) {
  FacetMesh mesh;
  mesh.positions = std::move(positions);
  mesh.facets = std::move(facets);
  mesh.part.of.assign(mesh.size(), 0);
  mesh.file_material.of.assign(mesh.size(), 0);
  for (std::uint32_t k = 0; k < mesh.size(); ++k) mesh.source_facet.push_back(k);
  mesh.part.names = {""};
  mesh.file_material.names = {""};
  measure_facets(mesh);
  return mesh;
}

// An axis-parallel box: 8 vertices, 12 facets, outward.
inline FacetMesh box(const Vec3& low, const Vec3& high) {
  std::vector<Vec3> positions;
  for (int k = 0; k < 8; ++k)
    positions.emplace_back((k & 1) != 0 ? high.x() : low.x(), (k & 2) != 0 ? high.y() : low.y(),
                           (k & 4) != 0 ? high.z() : low.z());
  return mesh_of(positions, {{0, 2, 1},
                             {1, 2, 3},
                             {4, 5, 6},
                             {5, 7, 6},
                             {0, 1, 4},
                             {1, 5, 4},
                             {2, 6, 3},
                             {3, 6, 7},
                             {0, 4, 2},
                             {2, 4, 6},
                             {1, 3, 5},
                             {3, 7, 5}});
}

inline FacetMesh unit_box() {
  return box({0, 0, 0}, {1, 1, 1});
}

inline FacetMesh reversed(FacetMesh mesh) {
  for (auto& facet : mesh.facets) std::swap(facet[1], facet[2]);
  measure_facets(mesh);
  return mesh;
}

// Both meshes in one: the second as a part of its own, or in the same part.
inline FacetMesh joined(FacetMesh a, const FacetMesh& b, bool own_part = false) {
  const auto offset = static_cast<std::uint32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const auto& f : b.facets) a.facets.push_back({f[0] + offset, f[1] + offset, f[2] + offset});
  if (own_part) a.part.names.push_back("part " + std::to_string(a.part.names.size()));
  a.part.of.resize(a.size(), static_cast<std::uint32_t>(a.part.names.size()) - 1);
  a.file_material.of.resize(a.size(), 0);
  while (a.source_facet.size() < a.size()) a.source_facet.push_back(static_cast<std::uint32_t>(a.source_facet.size()));
  measure_facets(a);
  return a;
}

// A band of n quads with half a turn in it: not orientable, one boundary of 2 n edges.
inline FacetMesh moebius(std::uint32_t n) {
  std::vector<Vec3> positions;
  Triangles facets;
  for (std::uint32_t k = 0; k < n; ++k) {
    const double turn = 2.0 * std::numbers::pi * k / n;
    for (const double side : {-0.3, 0.3}) {
      const double r = 1.0 + side * std::cos(turn / 2.0);
      positions.emplace_back(r * std::cos(turn), r * std::sin(turn), side * std::sin(turn / 2.0));
    }
  }
  for (std::uint32_t k = 0; k < n; ++k) {
    const bool last = k + 1 == n;
    const std::uint32_t a = 2 * k;
    const std::uint32_t c = last ? 1 : a + 2;
    const std::uint32_t d = last ? 0 : a + 3;
    facets.push_back({a, c, d});
    facets.push_back({a, d, a + 1});
  }
  return mesh_of(positions, facets);
}

// A folder of its own that goes with the object.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "lrcs-mesh-XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] std::filesystem::path write(const std::string& name, std::string_view content) const {
    std::ofstream(path_ / name, std::ios::binary) << content;
    return path_ / name;
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline FacetMesh mesh_of_file(const std::string& name, std::string_view content) {
  const Folder folder;
  return read_mesh(folder.write(name, content));
}

// What read_mesh() complains about, from after the folder's name; "" where it does not.
inline std::string complaint_about(const std::string& name, std::string_view content) {
  const Folder folder;
  try {
    const FacetMesh mesh = read_mesh(folder.write(name, content));
    return "";
  } catch (const InputError& error) {
    return std::string(error.what()).substr(folder.path().string().size() + 1);
  }
}

}  // namespace lrcs
