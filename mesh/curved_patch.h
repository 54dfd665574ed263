#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "base/vec3.h"

namespace lrcs {

// Seven places in a facet, by their weights on its corners, and Radon's rule over them: exact for polynomials of degree
// 5. lower: weights of degree 2 on the same places; what the two differ by tells the error.
// source: J. Radon, Monatshefte fuer Mathematik 52, 286-300, 1948.
struct PatchRule {
  static constexpr std::size_t size = 7;
  std::array<std::array<double, 3>, size> at;
  std::array<double, size> weight, lower;
};
[[nodiscard]] const PatchRule& patch_rule();

// What a facet of a curved surface stands for, at the places of patch_rule(): the surface's true normal, and the area
// of the whole facet if its surface were stretched everywhere as it is there. Below zero where the patch folds over.
// The integral of f(normal) over the patch is Sum weight area f(normal).
struct CurvedPatch {
  std::array<Vec3, PatchRule::size> normal;  // unit
  std::array<double, PatchRule::size> area;  // [the mesh's unit, squared]
  // From the middle of the side from corner k to corner k + 1 to the place on the surface that it stands for, which
  // lies over it and beside it; of parts of a patch not known: zero. [the mesh's unit]
  std::array<Vec3, 3> sagitta{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
};

// Normals, and areas over the facet's, nearer to the flat facet's than this are the facet's: sigma does not change
// beyond its rounding.
inline constexpr double patch_alike = 1e-12;

// The patches of a mesh.
struct CurvedFacets {
  static constexpr std::uint32_t flat = 0xffffffff;
  std::vector<std::uint32_t> of;  // index into patches, or flat; one a facet, or empty: all are flat
  std::vector<CurvedPatch> patches;
};

// The patch of the facet wound the other way, which exchanges its second and third corner.
void turn_over(CurvedPatch& patch);

// Normal times area of a patch, at any place on its facet: a polynomial of degree 2 and a bubble through the places of
// patch_rule().
class PatchPolynomial {
 public:
  explicit PatchPolynomial(const CurvedPatch& patch);

  // at: weights of the corners. value: [the mesh's unit, squared].
  [[nodiscard]] Vec3 at(const std::array<double, 3>& place) const;

  // The patch over a part of the facet, with corners at three places on it. A normal is zero where the area is.
  [[nodiscard]] CurvedPatch part(const std::array<std::array<double, 3>, 3>& corners) const;
  // The same, to count as such a share of the facet's area.
  [[nodiscard]] CurvedPatch part(const std::array<std::array<double, 3>, 3>& corners, double share) const;

 private:
  std::array<Vec3, PatchRule::size> coefficients_;
};

}  // namespace lrcs
