#pragma once
#include <TDocStd_Document.hxx>
#include <TopoDS_Shape.hxx>
#include <filesystem>
#include <string>

#include "mesh/file_format.h"

namespace lrcs {

// A CAD file as Open CASCADE holds it: products, instances, names, colours (XCAF). Lengths in millimetres.
struct CadDocument {
  Handle(TDocStd_Document) document;
  std::string unit;      // of the file; "mm" also where it says one that has no name here; "" where it says none
  double unit_mm = 1.0;  // [mm] of the file's unit
};

// error: InputError where the file is not read.
[[nodiscard]] CadDocument read_cad_document(const std::filesystem::path& file, FileFormat format);

}  // namespace lrcs
