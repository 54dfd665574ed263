#pragma once
#include <string>
#include <string_view>

#include "mesh/facet_mesh.h"

namespace lrcs {

// One reader a format, behind read_mesh(). `content` is the whole file without a byte order mark, `file` its name in
// messages.
// error: InputError at the place. A file without facets gives an empty mesh.
// The libraries at hand were tried first: tinyobjloader rounds half of all 9-digit decimals to a neighbouring double,
// OpenMesh drops and renumbers facets, neither they nor CGAL say where in the file an error is or keep STL solids'
// names.

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
