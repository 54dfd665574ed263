#include "mesh/normal_patches.h"

#include <cmath>

namespace lrcs {
namespace {

using CornerVectors = std::array<Vec3, 3>;

// The control points of a cubic Bezier triangle; side[j][k]: by corner j on the side to corner k.
struct BezierTriangle {
  CornerVectors corner;
  std::array<CornerVectors, 3> side;
  Vec3 middle;
};

// By corner `from`, in its tangent plane, on the side to `to`.
Vec3 control_point(const Vec3& from, const Vec3& to, const Vec3& normal) {
  const Vec3 chord = to - from;
  const Vec3 tangent = chord - chord.dot(normal) * normal;
  const double cosine = tangent.stableNorm() / chord.stableNorm();
  return from + tangent * (2.0 / (3.0 * cosine * (1.0 + cosine)));
}

BezierTriangle bezier_triangle(const CornerVectors& corners, const CornerVectors& normals) {
  BezierTriangle t;
  t.corner = corners;
  Vec3 sides = Vec3::Zero();
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t k = 0; k < 3; ++k) {
      if (j == k) continue;
      t.side[j][k] = control_point(corners[j], corners[k], normals[j]);
      sides += t.side[j][k] / 6.0;
    }
  t.middle = 1.5 * sides - (corners[0] + corners[1] + corners[2]) / 6.0;
  return t;
}

// The derivative by the weight of corner j at a place.
Vec3 derivative(const BezierTriangle& t, const std::array<double, 3>& w, std::size_t j) {
  const std::size_t k = (j + 1) % 3, l = (j + 2) % 3;
  return 3.0 * (w[j] * w[j] * t.corner[j] + 2.0 * w[j] * w[k] * t.side[j][k] + 2.0 * w[j] * w[l] * t.side[j][l] +
                w[k] * w[k] * t.side[k][j] + w[l] * w[l] * t.side[l][j] + 2.0 * w[k] * w[l] * t.middle);
}

CurvedPatch patch_of(const BezierTriangle& t, const Vec3& fallback) {
  CurvedPatch patch;
  for (std::size_t p = 0; p < PatchRule::size; ++p) {
    const auto& at = patch_rule().at[p];
    const Vec3 by_first = derivative(t, at, 0);
    const Vec3 vector = 0.5 * (derivative(t, at, 1) - by_first).cross(derivative(t, at, 2) - by_first);
    patch.area[p] = vector.stableNorm();
    patch.normal[p] = patch.area[p] > 0.0 ? Vec3(vector / patch.area[p]) : fallback;
  }
  for (std::size_t j = 0; j < 3; ++j) {
    const std::size_t k = (j + 1) % 3;
    patch.sagitta[j] = 0.375 * (t.side[j][k] + t.side[k][j] - t.corner[j] - t.corner[k]);
  }
  return patch;
}

enum class Bend { none, usable, unknown };

Bend bend_of(const CornerVectors& normals, const Vec3& flat) {
  Bend bend = Bend::none;
  for (const Vec3& normal : normals) {
    if (!(normal.dot(flat) >= std::cos(most_turned))) return Bend::unknown;
    if ((normal - flat).norm() > patch_alike) bend = Bend::usable;
  }
  return bend;
}

}  // namespace

std::vector<std::uint32_t> curve_by_normals(FacetMesh& mesh, const CornerNormals& normals) {
  std::vector<std::uint32_t> unknown;
  mesh.curved.of.assign(mesh.size(), CurvedFacets::flat);
  for (std::uint32_t k = 0; k < mesh.size(); ++k) {
    const Bend bend = mesh.areas[k] > 0.0 ? bend_of(normals[k], mesh.normals[k]) : Bend::none;
    if (bend == Bend::unknown) unknown.push_back(k);
    if (bend != Bend::usable) continue;
    mesh.curved.of[k] = static_cast<std::uint32_t>(mesh.curved.patches.size());
    mesh.curved.patches.push_back(patch_of(bezier_triangle(mesh.corners(k), normals[k]), mesh.normals[k]));
  }
  if (mesh.curved.patches.empty()) mesh.curved = {};
  return unknown;
}

}  // namespace lrcs
