// What liblrcs-vtk.so shows (cad/reader_module.h).
#include "cad/read_vtk.h"
#include "cad/reader_module.h"

extern "C" void lrcs_read(const lrcs::ReadRequest& request, std::string& bytes) {
  bytes += lrcs::bytes_of(lrcs::read_vtk(request.file, request.unit, request.tessellation.curving));
}
