#pragma once
#include "mesh/mesh_builder.h"
#include "mesh/ply_header.h"
#include "mesh/ply_rows.h"

namespace lrcs {

// The quick way through a binary PLY file: all rows of element vertex whose properties are single values, or of element
// face whose one property is a list of three corners, at once.
// value: whether it was taken, and `rows` is past them; false: nothing is taken, and what is there, or what is wrong
// with it, is for the row by row way to find.
// domain: rows stands at the element's first row; an element of a header that mesh/read_ply.cpp has checked.
[[nodiscard]] bool read_block(BinaryPlyRows& rows, const PlyElement& element, MeshBuilder& builder);
// There is none through text.
[[nodiscard]] inline bool read_block(TextPlyRows& /*rows*/, const PlyElement& /*element*/, MeshBuilder& /*builder*/) {
  return false;
}

}  // namespace lrcs
