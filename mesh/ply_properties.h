#pragma once
#include <array>
#include <cstddef>
#include <string_view>

#include "mesh/ply_header.h"

namespace lrcs {

// What the properties of a PLY file mean to a surface.
using PlyAxisNames = std::array<std::string_view, 3>;
inline constexpr PlyAxisNames ply_position_names{"x", "y", "z"}, ply_normal_names{"nx", "ny", "nz"};

[[nodiscard]] bool is_scalar(const PlyProperty& property);

// The corners of a face.
[[nodiscard]] bool is_index_list(const PlyProperty& property);

// What is read of a face besides its corners.
[[nodiscard]] bool is_word(const PlyProperty& property);

// 0, 1 or 2: the property is a number and has the name of that axis; else 3.
[[nodiscard]] std::size_t axis_of(const PlyProperty& property, const PlyAxisNames& names);

}  // namespace lrcs
