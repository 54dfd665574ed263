#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "mesh/facet_mesh.h"
#include "mesh/file_normals.h"

namespace lrcs {

// One reader a format, behind read_mesh(). `content` is the whole file without a byte order mark, `file` its name in
// messages.
// normals: get those of the file, in numbers that its facets know; null: not wanted, and not looked at.
// error: InputError at the place. A file without facets gives an empty mesh.
// CGAL reads OFF and binary STL, after a check that names the place of what is wrong. The rest is read here: a library
// would only be given what the check had already taken apart, for (measured on good files and on mutants of them)
// - text STL: CGAL 5.5 refuses facets of 4 vertices, SOLID in capitals, and solids with "facet" or "solid" in their
//   names, and keeps no names. OpenMesh 9 rounds decimals to floats, drops facets and cuts off the 4th vertex.
// - OBJ: CGAL refuses l statements, lines that a backslash continues and CR as line end, takes tabs between indices for
//   one index, and keeps no names. tinyobjloader 2.0rc10, double: not the nearest doubles in 999 of 1000 facets of
//   9-digit decimals; no comments behind faces, no continued lines. OpenMesh: floats, no names, no CR.
// - PLY: CGAL rounds text floats to float, has no 8- and 16-bit indices, misreads vertices with lists, takes memory for
//   any length of list that is named, and crashes on integer coordinates. OpenMesh: floats; 1 mutant in 15 crashes it,
//   1 in 9 hangs it.

// Text STL. A facet with more than 3 vertices is a polygon. Stored normals are not looked at, however wrong.
[[nodiscard]] FacetMesh read_text_stl(std::string_view content, const std::string& file);

// Binary STL, one part "". The count in the header must fit the size of the file.
[[nodiscard]] FacetMesh read_binary_stl(std::string_view content, const std::string& file);

// Wavefront OBJ: v, f, o, g, usemtl, and mtllib for colours; all else is passed over. Negative indices count back from
// the last vertex. Libraries are looked for beside the file. warnings: as of read_mesh(). With normals wanted, vn too,
// and every corner must have one.
[[nodiscard]] FacetMesh read_obj(std::string_view content, const std::string& file, std::vector<std::string>* warnings,
                                 FileNormals* normals);

// Polygon File Format 1.0: element vertex with x, y, z of any type, element face with a list vertex_indices (or
// vertex_index) of any integer type, in this order. Bytes red, green and blue of a face are its colour; its other
// integers are properties of facets. Floats, lists, other elements and what else vertices have are passed over. With
// normals wanted, nx, ny, nz of vertices are read, and must be there.
[[nodiscard]] FacetMesh read_ply(std::string_view content, const std::string& file, FileNormals* normals);

// Object File Format as text: OFF with any of the prefixes ST, C, N, one vertex or face a line. What follows a vertex's
// coordinates or a face's indices (normals, colours, textures) is passed over. With normals wanted, those of vertices
// are read where the prefix N says that they are there.
[[nodiscard]] FacetMesh read_off(std::string_view content, const std::string& file, FileNormals* normals);

}  // namespace lrcs
