#pragma once
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "mesh/facet_mesh.h"

namespace lrcs {

// A vertex on the open edge of a facet.
struct TJunction {
  std::uint32_t facet;
  std::uint32_t edge;  // from its corner `edge` to the next
  std::uint32_t vertex;
  double along;  // the vertex on that edge, 0 to 1
};

// Where a surface is all but joined: open edges (those of one facet) that a small gap keeps from each other.
struct Gaps {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> near_vertices;  // pairs on open edges, the lower index first
  std::vector<TJunction> t_junctions;
  bool complete = true;  // else the search stopped: there may be more
};

// Of the diagonal of a mesh's box: what gaps are sought in where the user says nothing.
constexpr double usual_gap_of_diagonal = 1e-6;

// The same [positions' unit].
[[nodiscard]] double usual_gap(const FacetMesh& mesh);

// The gaps of at most `tolerance` [positions' unit]. A vertex nearer to an edge's end than that is no T-junction but a
// near vertex. With tolerance 0 exact: vertices that lie on open edges.
// Stops after 20 pairs of overlapping boxes for every open edge, and ten million more.
// domain: a welded mesh, facets of three different vertices. One of area zero that joins edges leaves no gap there.
[[nodiscard]] Gaps find_gaps(const FacetMesh& welded, double tolerance);

// What close_gaps() did.
struct GapCounts {
  std::size_t welded = 0;       // vertices moved to one near by
  std::size_t t_junctions = 0;  // vertices put into the edge of another facet
  bool complete = true;
};

// Closes the gaps of at most `tolerance`: of vertices near each other the later ones move to the first (not to one that
// moved itself), facets are split where a vertex lies on their open edge. Facets that lose their area so are dropped.
// A piece that is split off comes last in the mesh. The mesh is measured afterwards.
// domain: as find_gaps(); no facets of area zero, no curved patches. error: no point of the surface moves by more than
// the tolerance. check: tests/mesh/gaps_test.cpp
GapCounts close_gaps(FacetMesh& welded, double tolerance);

}  // namespace lrcs
