#pragma once
#include <filesystem>
#include <span>

#include "mesh/facet_mesh.h"

namespace lrcs {

// A format in which a mesh is written, and the extension of its files. write: error: std::runtime_error where the file
// cannot be written.
struct WrittenFormat {
  const char* name;
  const char* extension;
  void (*write)(const std::filesystem::path& file, const FacetMesh& mesh);
};

// STL and PLY, binary and text. Coordinates are floats, as CAD programs write them; PLY is little-endian.
[[nodiscard]] std::span<const WrittenFormat> written_formats();

}  // namespace lrcs
