#pragma once
#include <filesystem>

#include "mesh/facet_mesh.h"

namespace lrcs {

// Adds properties of facets from a table (CSV): a line of column names `facet,NAME[,NAME...]`; then, in any order, a
// line for each polygon that has words: its number in the target's file (FacetMesh::source_facet), and a word a name.
// Polygons without a line have "". Blank lines and lines that begin with # do not count. The file may be gzip.
// domain: a mesh as it was read, or repaired.
// error: InputError at line and column: a number that is no polygon's, or comes again; cells too few or too many; a
// name that is empty, comes again, or that the mesh has already. The mesh is as it was then.
void add_facet_properties(FacetMesh& mesh, const std::filesystem::path& csv);

}  // namespace lrcs
