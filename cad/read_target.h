#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "cad/tessellation.h"
#include "mesh/facet_mesh.h"

namespace lrcs {

// A target's file, of any format that is read: a mesh's (mesh/read_mesh.h) or CAD (cad/read_cad.h).
struct TargetRead {
  FacetMesh mesh;            // in the file's axes; metres_per_unit is 1 where no one says a unit
  std::string unit;          // the user's, else what the file says; "" where no one says any
  std::string tessellation;  // how facets were made of surfaces, in words; "" where the file holds facets
  std::vector<std::string> warnings;
};

// Readers of other people's making run in a process of their own (cad/contained.h): a damaged file cannot end this one.
// unit: of base/length.h, what the file's numbers are to be taken for, whatever it says; "": what it says.
// error: InputError that names the file, and where it has lines the place.
[[nodiscard]] TargetRead read_target(const std::filesystem::path& file, const std::string& unit = "",
                                     const Tessellation& tessellation = {});

}  // namespace lrcs
