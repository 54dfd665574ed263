#pragma once
#include <filesystem>

#include "mesh/facet_mesh.h"

namespace lrcs {

// Reads a target from a file: STL (text, binary), OBJ, PLY (text, binary of either byte order), OFF, or such a file
// compressed by gzip. The format is
// known by the content; the extension decides only where content leaves it open.
// value: facets in file order, measured; coordinates are the doubles nearest to the decimals, or the file's floats.
// frame: unit and axes of the file.
// Parts: STL solids and OBJ o/g statements (the later of the two), by name: what has the same name is the same part.
// Materials: OBJ usemtl. Stored normals, colours, textures and material libraries are not read.
// Polygons are cut by mesh/polygon_cut.h.
// error: one InputError, "file:line:column: expected ...", for whatever cannot be used as it stands: no file, an empty
// one, UTF-16, no facets, a number that is none, NaN or infinite, a facet with fewer than 3 vertices, a vertex that
// does not exist, a truncated file, counts that the file is too short for (checked before memory is taken).
[[nodiscard]] FacetMesh read_mesh(const std::filesystem::path& file);

}  // namespace lrcs
