#pragma once
#include <filesystem>
#include <string>

#include "cad/curving.h"
#include "cad/imported_mesh.h"
#include "mesh/file_format.h"

namespace lrcs {

// Reads glTF 2 (text or binary) or 3MF through assimp: a tree of nodes, each with a place and perhaps with meshes.
// Parts: a node with meshes is one, by its path through the tree; nodes without a name have that of their mesh, or
// none.
//   Materials by their names; colours: the material's factor, without textures, in sRGB. Facets of a mirrored place are
//   turned. Points and lines are passed over.
// curving: by file_normals, glTF's NORMAL bends the facets, placed as the node is; 3MF has none, which is an error.
// unit: what the file's numbers are to be taken for, whatever it says; "": what it says (glTF: m; 3MF: its `unit`).
// error: InputError for a file that assimp does not read, an index of a vertex that is not there, no facets. Whatever
//   else a damaged file does is the caller's to contain. Animations, skins, morph targets and
//   instancing by extension are not applied, colours of single 3MF triangles not read: warnings say so. Extensions that
//   a file requires and that touch geometry are refused.
// check: tests/cad/read_nodes_test.cpp.
[[nodiscard]] ImportedMesh read_nodes(const std::filesystem::path& file, FileFormat format, const std::string& unit,
                                      const Curving& curving);

}  // namespace lrcs
