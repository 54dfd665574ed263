#pragma once
#include <TDocStd_Document.hxx>
#include <TopoDS_Shape.hxx>
#include <filesystem>
#include <string>
#include <vector>

#include "mesh/file_format.h"

namespace lrcs {

// A CAD file as Open CASCADE holds it: products, instances, names, colours (XCAF). Lengths in millimetres.
struct CadDocument {
  Handle(TDocStd_Document) document;
  std::string unit;  // of the file; "mm", to which lengths were brought, where it has no name here; "" if none is said
  double unit_mm = 1.0;  // [mm] of the file's unit; 0 where that is not known, or there are several
  std::vector<std::string> warnings;
};

// error: InputError where the file is not read.
[[nodiscard]] CadDocument read_cad_document(const std::filesystem::path& file, FileFormat format);

}  // namespace lrcs
