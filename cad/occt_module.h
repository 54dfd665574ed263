#pragma once
#include <string>

#include "cad/tessellation.h"
#include "mesh/file_format.h"

namespace lrcs {

// Open CASCADE is thirty shared libraries, which take longer to be loaded than most sweeps do to be computed: they come
// with liblrcs-occt.so, which is loaded where a CAD file is read, in the process that reads it.

// What is asked of it.
struct CadRequest {
  std::string file;
  FileFormat format;
  std::string unit;
  Tessellation tessellation;
};

// read_cad() as bytes: a mesh, its unit, warnings (cad/mesh_bytes.h). The name in the library: "lrcs_read_cad".
using ReadCadFunction = void(const CadRequest& request, std::string& bytes);

// Loads the library: from the folder of the program, ../lib/lrcs beside that, where it was installed, or where the
// system looks for libraries. error: std::runtime_error that names them.
[[nodiscard]] ReadCadFunction* load_occt_module();

}  // namespace lrcs
