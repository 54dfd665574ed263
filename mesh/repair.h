#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/facet_mesh.h"

namespace lrcs {

// What repair() did.
struct RepairCounts {
  std::size_t welded_vertices = 0;  // positions that repeated an earlier one
  std::size_t degenerate = 0;       // facets of area exactly zero, dropped
  std::size_t duplicate = 0;        // facets that repeated an earlier one, dropped
  std::size_t flipped = 0;          // facets whose winding was reversed
  std::size_t inward_shells = 0;    // closed shells most of whose facets were turned to face outward
};

// What was done to the whole, and to the facets of each part, in the order of mesh.part.names.
// Vertices are welded across parts: of parts welded_vertices is 0; nor is a shell of several parts counted for one.
struct RepairsByPart {
  RepairCounts all;
  std::vector<RepairCounts> parts;
};

// Puts a mesh in order without changing which surface it is.
// Welds vertices of exactly equal position; drops facets whose corners are exactly collinear or equal; drops facets
// with the same three positions in the same winding as an earlier one (with the opposite winding it is the back of a
// sheet, and stays); makes closed shells face outward (closed_shells.h: cavities and bodies inside a shell keep their
// side; open and non-orientable pieces stay as they are). The mesh is measured afterwards.
// Collinear facets are what closes a shell where a vertex lies on a neighbour's edge: they count while shells are
// looked for, and go last.
// laws: kept facets keep their order, part, material, source facet and, where not flipped, their winding; area and
// shadow of the target do not change; repairing again does nothing, unless a collinear facet went that closed a shell.
RepairCounts repair(FacetMesh& mesh);

// All of repair() but for the collinear facets, which are counted and stay.
RepairsByPart repair_connectivity(FacetMesh& mesh);

// The facets that have the vertices of an earlier one in the opposite winding: the back of a sheet, or a wall between
// two bodies. value: ascending. domain: a mesh that repair_connectivity() made.
[[nodiscard]] std::vector<std::uint32_t> opposite_facets(const FacetMesh& mesh);

// Drops the facets of area exactly zero, and says how many they were. The mesh is measured afterwards.
std::size_t drop_degenerate(FacetMesh& mesh);

}  // namespace lrcs
