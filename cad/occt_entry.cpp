// What liblrcs-occt.so shows (cad/occt_module.h).
#include "cad/mesh_bytes.h"
#include "cad/occt_module.h"
#include "cad/read_cad.h"

extern "C" void lrcs_read_cad(const lrcs::CadRequest& request, std::string& bytes) {
  const lrcs::CadMesh cad = lrcs::read_cad(request.file, request.format, request.unit, request.tessellation);
  bytes = lrcs::bytes_of_mesh(cad.mesh);
  lrcs::append_words(bytes, {cad.unit});
  lrcs::append_words(bytes, cad.warnings);
}
