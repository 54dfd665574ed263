#pragma once
#include <filesystem>
#include <string>

#include "cad/imported_mesh.h"
#include "cad/tessellation.h"
#include "mesh/file_format.h"

namespace lrcs {

// Reads STEP (AP203, AP214, AP242), IGES or BREP through Open CASCADE. Lengths of the mesh are millimetres, or what the
// file has where it says no unit (BREP).
// Parts: each solid that is placed somewhere is one, by its path through the assembly: "as1/l-bracket-assembly:2/bolt";
//   of siblings of one name each is numbered in file order, ":1", ":2". Surfaces outside solids are parts of their own.
// Colours, layers and materials of a face: its own, else its solid's, else those of the placed instance, of the
// product,
//   and of what these are part of, in this order. Names are UTF-8.
// Facets face outward as the faces say (REVERSED ones, mirrored placements); each instance is there.
// error: InputError for a file that Open CASCADE does not read, and one without any surface. Entities that are not
//   read and surfaces that cannot be made facets are warned of. Whatever else a damaged file does (a signal, no end) is
//   the caller's to contain.
// check: tests/cad/read_target_test.cpp, real_files_test.cpp.
// unit: what the file's numbers are to be taken for, whatever it says; "": what it says.
[[nodiscard]] ImportedMesh read_cad(const std::filesystem::path& file, FileFormat format, const std::string& unit,
                                    const Tessellation& tessellation);

}  // namespace lrcs
