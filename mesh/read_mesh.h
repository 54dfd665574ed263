#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "mesh/facet_mesh.h"
#include "mesh/file_normals.h"

namespace lrcs {

// Reads a target from a file: STL (text, binary), OBJ, PLY (text, binary of either byte order), OFF, or such a file
// compressed by gzip. The format is
// known by the content; the extension decides only where content leaves it open.
// value: facets in file order, measured; coordinates are the doubles nearest to the decimals, or the file's floats.
// frame: unit and axes of the file.
// Parts: STL solids and OBJ o/g statements (the later of the two), by name: what has the same name is the same part.
// Materials: OBJ usemtl. Colours: OBJ material libraries (mesh/mtl_colours.h), PLY red, green, blue of faces.
// Properties: PLY whole numbers of faces. Colours of vertices and textures are not read, normals where they are
// wanted: by `normals`, which get them, and may be null. Polygons are
// cut by mesh/polygon_cut.h. error: one InputError, "file:line:column: expected ...", for whatever cannot be used as it
// stands: no file, an empty one, UTF-16, no facets, a number that is none, NaN or infinite, a facet with fewer than 3
// vertices, a vertex that does not exist, a truncated file, counts that the file is too short for (checked before
// memory is taken). warnings: what of it was not read and perhaps was wanted, a line each; may be null.
[[nodiscard]] FacetMesh read_mesh(const std::filesystem::path& file, std::vector<std::string>* warnings = nullptr,
                                  FileNormals* normals = nullptr);

}  // namespace lrcs
