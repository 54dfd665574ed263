#pragma once
#include <string>
#include <string_view>

#include "mesh/facet_mesh.h"

namespace lrcs {

// One reader a format, behind read_mesh(). `content` is the whole file without a byte order mark, `file` its name in
// messages.
// error: InputError at the place. A file without facets gives an empty mesh.
// Why not the readers of libraries (all tried on targets, broken files and mutants of small ones): tinyobjloader
// 2.0rc10, double: not the nearest doubles in 998 of 1000 facets of 9-digit decimals. OpenMesh 9: decimals rounded to
// floats, facets dropped. CGAL 5.5 OBJ, STL: no names of parts and materials; STL skips words it does not know and
// merges a NaN vertex with another; PLY rounds text floats to float, has no 8- and 16-bit indices, crashes on integer
// coordinates and takes 1.5 GB for a list of 4e8 that the file has not; OFF reads "3,5" as 3 and vertex 1.7 as one, and
// takes 766 MB for a face of 1e8 corners that the file has not: refusing that before takes a scan of every row.

// Text STL. A facet with more than 3 vertices is a polygon. Stored normals are not looked at, however wrong.
[[nodiscard]] FacetMesh read_text_stl(std::string_view content, const std::string& file);

// Binary STL, one part "". The count in the header must fit the size of the file.
[[nodiscard]] FacetMesh read_binary_stl(std::string_view content, const std::string& file);

// Wavefront OBJ: v, f, o, g, usemtl; all else is passed over. Negative indices count back from the last vertex.
[[nodiscard]] FacetMesh read_obj(std::string_view content, const std::string& file);

// Polygon File Format 1.0: element vertex with x, y, z of any type, element face with a list vertex_indices (or
// vertex_index) of any integer type, in this order. Other elements and properties are passed over.
[[nodiscard]] FacetMesh read_ply(std::string_view content, const std::string& file);

// Object File Format as text: OFF with any of the prefixes ST, C, N, one vertex or face a line. What follows a vertex's
// coordinates or a face's indices (normals, colours, textures) is passed over.
[[nodiscard]] FacetMesh read_off(std::string_view content, const std::string& file);

}  // namespace lrcs
