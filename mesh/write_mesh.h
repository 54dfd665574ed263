#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "mesh/facet_mesh.h"

namespace lrcs {

// Extensions of the formats that write_mesh() writes: .obj .ply .off .stl
[[nodiscard]] const std::vector<std::string>& mesh_extensions();

// Has the file one of those extensions? In upper case, too.
[[nodiscard]] bool writes_mesh(const std::filesystem::path& file);

// Writes a mesh in the format of the file's extension (upper or lower case), positions in the mesh's own unit.
// value: OBJ: text, parts as `o`, materials as `usemtl`; PLY: binary, doubles; OFF: text; STL: binary, single
// precision,
//   vertices rounded to the nearest float. Numbers in text read back to the same double. Only OBJ keeps parts and
//   materials.
// laws: read_mesh() gives the same facets in the same order, but in OBJ part by part.
// error: InputError for another extension; std::runtime_error where it cannot be written. It appears whole or not at
// all. check: tests/mesh/write_mesh_test.cpp
void write_mesh(const std::filesystem::path& file, const FacetMesh& mesh);

}  // namespace lrcs
