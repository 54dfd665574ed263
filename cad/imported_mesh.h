#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "mesh/facet_mesh.h"

namespace lrcs {

// What a reader found.
struct ImportedMesh {
  FacetMesh mesh;    // in the file's axes; metres_per_unit is set, or 1 where no one says a unit
  std::string unit;  // the user's, else the file's: "mm", "inch", ...; "" where no one says any
  std::vector<std::string> warnings;
};

// As bytes and back, for another process of this program on this machine.
// law: imported_of(bytes_of(m)) is m, bit for bit, measured. error: std::runtime_error for bytes that are none.
[[nodiscard]] std::string bytes_of(const ImportedMesh& imported);
[[nodiscard]] ImportedMesh imported_of(std::string_view bytes);

}  // namespace lrcs
