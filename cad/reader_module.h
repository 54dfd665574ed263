#pragma once
#include <string>

#include "cad/tessellation.h"
#include "mesh/file_format.h"

namespace lrcs {

// The libraries that read other people's formats (Open CASCADE alone is thirty shared libraries) take longer to be
// loaded than most sweeps do to be computed. They come with liblrcs-occt.so, liblrcs-assimp.so and liblrcs-vtk.so,
// which are loaded where such a file is read, in the process that reads it.

// What is asked of one.
struct ReadRequest {
  std::string file;
  FileFormat format;
  std::string unit;
  Tessellation tessellation;
};

// Appends an ImportedMesh as bytes (cad/imported_mesh.h). Its name in each library: "lrcs_read".
using ReadFunction = void(const ReadRequest& request, std::string& bytes);

// reader: "occt", "assimp" or "vtk". Its library is looked for in the folder of the program, in ../lib/lrcs beside
// that, where it was installed, and where the system looks for libraries. error: ReaderNotLoaded.
[[nodiscard]] ReadFunction* load_reader(const std::string& reader);

}  // namespace lrcs
