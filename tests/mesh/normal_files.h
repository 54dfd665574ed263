#pragma once
#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "made_round_meshes.h"
#include "mesh/corner_normals.h"
#include "mesh_files.h"

namespace lrcs {

// A mesh with a normal at every corner of its facets.
struct CornerMesh {
  FacetMesh mesh;
  CornerNormals normals;
};

// The same with vertices of its own for every facet: what formats with a normal a vertex need at sharp edges.
struct VertexMesh {
  FacetMesh mesh;
  std::vector<Vec3> normals;
};
inline VertexMesh unwelded(const CornerMesh& corners) {
  VertexMesh made;
  std::vector<Vec3> positions;
  Triangles facets;
  for (std::size_t k = 0; k < corners.mesh.size(); ++k) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    facets.push_back({first, first + 1, first + 2});
    for (std::size_t c = 0; c < 3; ++c) {
      positions.push_back(corners.mesh.corners(k)[c]);
      made.normals.push_back(corners.normals[k][c]);
    }
  }
  made.mesh = mesh_of(std::move(positions), std::move(facets));
  return made;
}

// Coordinates and normals as floats: files of every format then hold the same.
inline void round_to_floats(CornerMesh& made) {
  // Through memory: g++ 12 leaves the last of vectorized casts there and back out.
  const auto round = [](Vec3& v) {
    for (double& x : v) {
      const volatile float rounded = static_cast<float>(x);
      x = static_cast<double>(rounded);
    }
  };
  for (Vec3& p : made.mesh.positions) round(p);
  for (auto& corners : made.normals)
    for (Vec3& n : corners) round(n);
  measure_facets(made.mesh);
}

// A unit sphere with its own normals.
inline CornerMesh ball_with_normals(int levels, double jitter) {
  CornerMesh ball{jittered_ball(levels, jitter, 5), {}};
  for (std::size_t k = 0; k < ball.mesh.size(); ++k) ball.normals.push_back(ball.mesh.corners(k));
  return ball;
}

// A cylinder with caps, whose rims are sharp.
inline CornerMesh cylinder_with_normals(std::uint32_t sides, double height) {
  CornerMesh tube{cylinder(sides, height), {}};
  for (std::size_t k = 0; k < tube.mesh.size(); ++k) {
    const Vec3& flat = tube.mesh.normals[k];
    auto& normals = tube.normals.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3 p = tube.mesh.corners(k)[c];
      normals[c] = std::abs(flat.z()) > 0.5 ? Vec3(0.0, 0.0, std::copysign(1.0, flat.z())) : Vec3(p.x(), p.y(), 0.0);
    }
  }
  return tube;
}

inline std::string obj(const CornerMesh& made) {
  std::string text;
  for (const Vec3& p : made.mesh.positions) text += fmt::format("v {} {} {}\n", p.x(), p.y(), p.z());
  for (const auto& corners : made.normals)
    for (const Vec3& n : corners) text += fmt::format("vn {} {} {}\n", n.x(), n.y(), n.z());
  for (std::size_t k = 0; k < made.mesh.size(); ++k) {
    const auto& f = made.mesh.facets[k];
    text += fmt::format("f {}//{} {}//{} {}//{}\n", f[0] + 1, 3 * k + 1, f[1] + 1, 3 * k + 2, f[2] + 1, 3 * k + 3);
  }
  return text;
}

inline std::string noff(const VertexMesh& made) {
  std::string text = fmt::format("NOFF\n{} {} 0\n", made.mesh.positions.size(), made.mesh.size());
  for (std::size_t k = 0; k < made.normals.size(); ++k) {
    const Vec3 &p = made.mesh.positions[k], &n = made.normals[k];
    text += fmt::format("{} {} {} {} {} {}\n", p.x(), p.y(), p.z(), n.x(), n.y(), n.z());
  }
  for (const auto& f : made.mesh.facets) text += fmt::format("3 {} {} {}\n", f[0], f[1], f[2]);
  return text;
}

// The normals before the positions.
inline std::string ply(const VertexMesh& made, const std::string& encoding) {
  std::string text = fmt::format(
      "ply\nformat {} 1.0\nelement vertex {}\nproperty float nx\nproperty double ny\nproperty double nz\n"
      "property double x\nproperty double y\nproperty double z\nelement face {}\n"
      "property list uchar int vertex_indices\nend_header\n",
      encoding, made.mesh.positions.size(), made.mesh.size());
  const bool is_text = encoding == "ascii", big = encoding == "binary_big_endian";
  for (std::size_t k = 0; k < made.normals.size(); ++k) {
    const Vec3 &p = made.mesh.positions[k], &n = made.normals[k];
    if (is_text) {
      text += fmt::format("{} {} {} {} {} {}\n", n.x(), n.y(), n.z(), p.x(), p.y(), p.z());
      continue;
    }
    text += bytes_of(static_cast<float>(n.x()), big);
    for (const double x : {n.y(), n.z(), p.x(), p.y(), p.z()}) text += bytes_of(x, big);
  }
  for (const auto& f : made.mesh.facets) {
    text += is_text ? "3" : "\x03";
    for (const std::uint32_t index : f) text += is_text ? fmt::format(" {}", index) : bytes_of(index, big);
    if (is_text) text += "\n";
  }
  return text;
}

}  // namespace lrcs
