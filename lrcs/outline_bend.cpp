#include "lrcs/outline_bend.h"

#include <algorithm>
#include <cmath>

namespace lrcs {
namespace {

// One of the two facets at an edge.
struct FacetBeside {
  std::array<Vec3, 3> at, normal;  // of its corners
  Vec3 low, high;                  // normals at the edge's ends

  FacetBeside(const Occluders& occluders, std::uint32_t facet, const OccluderEdges::Edge& edge) {
    normal = occluders.corner_normals[facet];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = occluders.facets[facet][k];
      at[k] = occluders.positions[vertex];
      if (vertex == edge.low) low = normal[k];
      if (vertex == edge.high) high = normal[k];
    }
  }

  // How the surface curves along a direction in its plane, which need not be unit: positive where it bulges.
  [[nodiscard]] double curvature(const Vec3& along) const {
    const Vec3 e1 = at[1] - at[0], e2 = at[2] - at[0];
    const double a = e1.squaredNorm(), b = e1.dot(e2), c = e2.squaredNorm();
    const double p = along.dot(e1), q = along.dot(e2), det = a * c - b * b;
    if (!(det > 0.0)) return 0.0;
    const Vec3 turned =
        (c * p - b * q) / det * (normal[1] - normal[0]) + (a * q - b * p) / det * (normal[2] - normal[0]);
    return turned.dot(along) / along.squaredNorm();
  }

  // Of the arc over the edge, from a to b.
  [[nodiscard]] double sagitta(const Vec3& a, const Vec3& b) const { return (high - low).dot(b - a) / 8.0; }
};

Vec3 across(const Vec3& v, const Vec3& toward) {
  return v - v.dot(toward) * toward;
}

// Where the surface turns away from the viewer, from a place on it near to there.
Vec3 to_fold(const FacetBeside& one, const FacetBeside& other, const Vec3& n, const Vec3& toward, double reach) {
  const double lean = n.dot(toward);
  const Vec3 along = toward - lean * n;
  const double curvature = 0.5 * (one.curvature(along) + other.curvature(along));
  // Further than two facets away it is not this edge that stands for it.
  // A sheet may be wound either way: then the normal and the curvature have the other sign.
  if (!(std::abs(curvature) * 2.0 * reach > std::abs(lean))) return Vec3::Zero();
  return 0.5 * lean * lean / curvature * n;
}

}  // namespace

OutlineBend outline_bend(const Occluders& occluders, const OccluderEdges::Edge& edge, const Vec3& toward) {
  const FacetBeside one(occluders, edge.use[0] / 2, edge), other(occluders, edge.use[1] / 2, edge);
  const Vec3 &a = occluders.positions[edge.low], &b = occluders.positions[edge.high];
  Vec3 at_low = Vec3::Zero(), at_middle = Vec3::Zero(), at_high = Vec3::Zero();
  if (one.low.dot(other.low) > Occluders::smooth && one.high.dot(other.high) > Occluders::smooth) {
    double reach = (b - a).norm();
    for (const FacetBeside* facet : {&one, &other})
      for (const Vec3& corner : facet->at) reach = std::max(reach, (corner - a).norm());
    const Vec3 low = (one.low + other.low).normalized(), high = (one.high + other.high).normalized();
    const Vec3 middle = (low + high).normalized();
    at_low = to_fold(one, other, low, toward, reach);
    at_high = to_fold(one, other, high, toward, reach);
    at_middle = to_fold(one, other, middle, toward, reach) + 0.5 * (one.sagitta(a, b) + other.sagitta(a, b)) * middle;
  } else {
    // On both surfaces: the two rises are its shares along the two normals.
    const Vec3 n = (one.low + one.high).normalized(), m = (other.low + other.high).normalized();
    const double cosine = n.dot(m), rest = 1.0 - cosine * cosine;
    const double along_n = one.sagitta(a, b), along_m = other.sagitta(a, b);
    constexpr double sharp = 0.01;  // nearly tangent, or a thin edge: the two rises say the same
    at_middle = rest > sharp ? Vec3(((along_n - cosine * along_m) * n + (along_m - cosine * along_n) * m) / rest)
                             : Vec3(0.5 * (along_n * n + along_m * m));
  }
  const Vec3 more = 2.0 / 3.0 * (at_middle - 0.5 * (at_low + at_high));
  const OutlineBend bend{across(at_low + more, toward), across(at_high + more, toward)};
  return bend.at_low.allFinite() && bend.at_high.allFinite() ? bend : OutlineBend{};
}

}  // namespace lrcs
