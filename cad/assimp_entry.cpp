// What liblrcs-assimp.so shows (cad/reader_module.h).
#include "cad/read_nodes.h"
#include "cad/reader_module.h"

extern "C" void lrcs_read(const lrcs::ReadRequest& request, std::string& bytes) {
  bytes += lrcs::bytes_of(lrcs::read_nodes(request.file, request.format, request.unit, request.tessellation.curving));
}
