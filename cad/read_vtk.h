#pragma once
#include <filesystem>
#include <string>

#include "cad/curving.h"
#include "cad/imported_mesh.h"

namespace lrcs {

// Reads VTK XML files through VTK: polygons and strips of PolyData (.vtp), the outer faces of an UnstructuredGrid
// (.vtu). Facet properties: the cell arrays of whole numbers or of words with one component. The index `part` with the
// words
//   `part_names`, as in the facet files of a sweep, gives parts; else all is one part, "".
// unit: of the file's numbers; the format has none of its own.
// curving: by file_normals, point data that are the file's normals, or have the name Normals, bend the facets.
// error: InputError for a file that VTK does not read, numbers that are not finite, no facets.
// check: tests/cad/read_vtk_test.cpp.
[[nodiscard]] ImportedMesh read_vtk(const std::filesystem::path& file, const std::string& unit, const Curving& curving);

}  // namespace lrcs
