#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "mesh/facet_mesh.h"

namespace lrcs {

// A format in which write_mesh() writes, and the extension of its files.
struct WrittenFormat {
  const char* name;
  const char* extension;
  void (*append)(const FacetMesh& mesh, std::string& bytes);
};

// STL and PLY, binary and text. Coordinates are floats, as CAD programs write them; PLY is little-endian.
[[nodiscard]] std::span<const WrittenFormat> written_formats();

// error: std::runtime_error where the file cannot be written.
void write_mesh(const FacetMesh& mesh, const WrittenFormat& format, const std::filesystem::path& file);

}  // namespace lrcs
