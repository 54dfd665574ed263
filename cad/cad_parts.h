#pragma once
#include <TopoDS_Face.hxx>
#include <string>
#include <vector>

#include "cad/cad_document.h"

namespace lrcs {

// What a CAD file says of a face besides its shape; "": nothing.
struct CadLook {
  std::string colour;  // #rrggbb, in sRGB
  std::string layer;
  std::string material;
};

struct CadFace {
  TopoDS_Face face;  // placed
  CadLook look;
};

// A solid that is placed somewhere, or the surfaces outside solids of one product there.
struct CadPart {
  std::string path;
  TopoDS_Shape body;  // the same for all instances, not placed: its tessellation serves them all
  std::vector<CadFace> faces;
};

// In file order. See read_cad.h for paths, and for whose colour counts.
// error: InputError with `file` for more than most_parts.
constexpr std::size_t most_parts = 1000000;
[[nodiscard]] std::vector<CadPart> cad_parts(const CadDocument& read, const std::string& file);

}  // namespace lrcs
