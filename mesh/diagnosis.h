#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mesh/facet_mesh.h"
#include "mesh/self_intersections.h"

namespace lrcs {

// What is wrong with a mesh, or with one part of it.
struct Defects {
  std::size_t degenerate = 0;          // facets of area exactly zero
  std::size_t duplicate = 0;           // facets that repeat an earlier one, winding included
  std::size_t opposite = 0;            // facets that repeat an earlier one in the opposite winding
  std::size_t flipped = 0;             // facets of closed shells whose winding points inward
  std::size_t inward_shells = 0;       // closed shells most of whose facets are flipped; of a part: closed by itself
  std::size_t against_most = 0;        // facets of open pieces wound against most of their neighbours (windings.h)
  std::size_t non_manifold_edges = 0;  // edges of more than two facets
  std::size_t boundary_edges = 0;      // edges of one facet
  std::size_t holes = 0;               // rims of such edges: outlines of sheets, too (holes.h)
  std::size_t t_junctions = 0;         // vertices on the boundary edge of another facet (gaps.h)
};

// What is known of one part. Lengths in metres by the mesh's metres_per_unit.
struct PartDiagnosis : Defects {
  std::string name;
  std::size_t facets = 0;
  double area = 0.0;
  bool closed = false;           // by itself: its facets bound a volume
  std::optional<double> volume;  // enclosed, cavities taken off; none where the part is open
  // As the file names them; several: joined with ", "; "" where it names none.
  std::string file_material, colour, layer;
};

// What facets of one colour or material of the file are together.
struct NamedFacets {
  std::string name;
  std::size_t facets = 0;
  double area = 0.0;
};

// Two parts that touch or pass through each other.
struct PartsMeeting {
  std::string one, other;
  std::size_t facet_pairs = 0;
};

// What was read, before any repair: the numbers of `lrcs info`.
// Vertices of equal position are one vertex throughout. Edges, closedness and volume are those of the mesh without
// facets that have two equal corners or repeat an earlier facet; facets whose three corners are collinear count there,
// because they close the edges where a vertex lies on a neighbour's edge. Edges are of the whole: those that two parts
// share are no boundary of either. Self-intersections are those of the mesh that repair() makes.
struct Diagnosis : Defects {
  std::size_t facets = 0;
  std::size_t vertices = 0;  // different positions that facets use
  double area = 0.0;
  double volume = 0.0;                   // enclosed by closed shells, cavities taken off; 0 where nothing is closed
  std::array<Vec3, 2> box{};             // of the facets: least and greatest coordinates
  bool closed = false;                   // every edge has an even number of facets
  double gap = 0.0;                      // [m] within which T-junctions and near vertices were sought (usual_gap())
  std::size_t near_vertices = 0;         // pairs on boundary edges that are so near, and not equal
  bool gaps_complete = true;             // else there may be more of both
  std::size_t normals_against = 0;       // facets whose normal in the file points to their back
  SelfIntersections self_intersections;  // pairs of facets
  std::vector<PartsMeeting> meeting;     // those among the pairs that are of two parts, the most pairs first
  std::vector<PartDiagnosis> parts;      // in file order
  std::vector<NamedFacets> colours, file_materials;  // with a name, in file order
  std::vector<std::string> properties;               // names of the facets' properties
};

// check: made bodies with known counts, and a half-edge mesh as a second route (tests/mesh/diagnosis_test.cpp).
[[nodiscard]] Diagnosis diagnose(const FacetMesh& mesh);

}  // namespace lrcs
