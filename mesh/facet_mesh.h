#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/vec3.h"
#include "mesh/curved_patch.h"

namespace lrcs {

// What a file says of facets in words: names, and which of them each facet has.
struct FacetNames {
  std::vector<std::uint32_t> of;   // index into names, one a facet; empty: the file tells of no facet
  std::vector<std::string> names;  // "" stands for those without one
};

// What a file says of facets under a name of its own: a cell array of VTP. Whole numbers and words, as text.
struct FacetProperty {
  std::string name;
  FacetNames values;
};

// A target as triangular facets, in arrays: what the integrator reads.
// shape: every per-facet array has one entry a facet. Positions may repeat: `facets` says nothing of connectivity.
// frame: the file's axes until place_in_body_frame() (mesh/body_frame.h).
struct FacetMesh {
  std::vector<Vec3> positions;                       // vertices, in the file's unit: exactly as they were read
  std::vector<std::array<std::uint32_t, 3>> facets;  // indices into positions, counter-clockwise seen from the front
  std::vector<std::uint32_t> source_facet;           // number of the polygon (CAD: face) in the file, from 0
  FacetNames part;           // never empty where there are facets: where the file names no part, all are one, ""
  FacetNames file_material;  // the same of materials
  FacetNames colour;         // #rrggbb; may be empty
  FacetNames layer;          // may be empty
  std::vector<FacetProperty> properties;
  CurvedFacets curved;  // what facets of curved surfaces stand for

  std::size_t normals_against = 0;  // facets whose normal in the file points to the back of their winding, as read

  double metres_per_unit = 1.0;  // [m]: scaling the positions would round, and what is coplanar would not stay so

  // Set by measure_facets(), and kept true by every function of this folder that changes a mesh.
  std::vector<Vec3> normals;  // unit, by the winding; zero for a facet of area exactly zero
  std::vector<double> areas;  // [m^2]

  [[nodiscard]] std::size_t size() const { return facets.size(); }
  [[nodiscard]] std::array<Vec3, 3> corners(std::size_t facet) const {
    const auto& f = facets[facet];
    return {positions[f[0]], positions[f[1]], positions[f[2]]};
  }
};

// Cross product (b - a) x (c - a): twice the area times the unit normal.
// domain: coordinates up to 1e100 and, where not equal, at least 1e-100 apart; beyond, products over- or underflow.
// laws: exactly zero where a, b, c are collinear, and only there; turns into its opposite where two corners are
// swapped.
// error: 2 units in the last place of every component, the differences' rounding included, however thin the facet.
// check: against rational arithmetic in tests/mesh/facet_mesh_test.cpp.
// source: T. J. Dekker, Numer. Math. 18, 224-242, 1971 (error-free product); J. R. Shewchuk, Discrete Comput. Geom. 18,
// 305-363, 1997 (exact sum of expansions). std::fma is exact with and without the instruction.
[[nodiscard]] Vec3 facet_cross(const Vec3& a, const Vec3& b, const Vec3& c);

// Fills normals and areas from the positions.
// error: 4 units in the last place of every area.
void measure_facets(FacetMesh& mesh);

// Of the box of all facets, corner to corner [positions' unit]; 0 without facets.
[[nodiscard]] double diagonal_of(const FacetMesh& mesh);

}  // namespace lrcs
