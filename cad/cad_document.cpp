#include "cad/cad_document.h"

#include <fmt/format.h>

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Check.hxx>
#include <Interface_CheckIterator.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

#include "base/input_error.h"

namespace lrcs {
namespace {

struct UnitName {
  std::string_view word;  // in a STEP file
  const char* name;
  double mm;
};

constexpr std::array unit_names{
    UnitName{"millimetre", "mm", 1.0},  UnitName{"metre", "m", 1e3},        UnitName{"centimetre", "cm", 10.0},
    UnitName{"decimetre", "dm", 100.0}, UnitName{"micrometre", "um", 1e-3}, UnitName{"kilometre", "km", 1e6},
    UnitName{"inch", "inch", 25.4},     UnitName{"foot", "ft", 304.8},      UnitName{"mil", "mil", 0.0254}};

void set_unit(CadDocument& read, std::string_view word) {
  std::string small(word);
  std::transform(small.begin(), small.end(), small.begin(), [](unsigned char c) { return std::tolower(c); });
  read.unit = "mm";
  read.unit_mm = 0.0;
  for (const UnitName& u : unit_names)
    if (small == u.word) {
      read.unit = u.name;
      read.unit_mm = u.mm;
    }
}

// The same where a length in millimetres is what the file says.
void set_unit(CadDocument& read, double mm) {
  constexpr double digits = 1e-9;  // relative: of the numbers in an IGES header
  read.unit = "mm";
  read.unit_mm = mm;
  for (const UnitName& u : unit_names)
    if (std::abs(mm - u.mm) <= digits * u.mm) read.unit = u.name;
}

void warn(CadDocument& read, const std::string& warning) {
  constexpr std::size_t most = 20;
  if (read.warnings.size() < most) read.warnings.push_back(warning);
}

// What could not be read, which is missing then: as many lines as there are kinds of complaints.
void warn_of_failures(CadDocument& read, const Interface_CheckIterator& check) {
  std::map<std::string, int> counts;
  for (check.Start(); check.More(); check.Next())
    for (int k = 1; k <= check.Value()->NbFails(); ++k) {
      std::string words = check.Value()->CFail(k);
      for (char& c : words)
        if (static_cast<unsigned char>(c) < 0x20) c = ' ';
      ++counts[words];
    }
  for (const auto& [words, count] : counts)
    warn(read, fmt::format("{} entit{} could not be read, what hangs on {} is missing: {}", count,
                           count == 1 ? "y" : "ies", count == 1 ? "it" : "them", words));
}

void warn_of_failures(CadDocument& read, const Handle(XSControl_WorkSession) & session) {
  warn_of_failures(read, session->ModelCheckList());
  warn_of_failures(read, session->TransferReader()->LastCheckList());
}

template <class Reader>
void set_modes(Reader& reader) {
  reader.SetNameMode(true);
  reader.SetColorMode(true);
  reader.SetLayerMode(true);
}

void require(bool good, const std::string& file, const char* what) {
  if (!good) throw InputError(Place{file}, what);
}

void read_step(const std::string& file, CadDocument& read) {
  STEPCAFControl_Reader reader;
  set_modes(reader);
  reader.SetMatMode(true);
  reader.SetSHUOMode(true);
  require(reader.ReadFile(file.c_str()) == IFSelect_RetDone, file, "is not read as a STEP file: damaged?");
  TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
  reader.ChangeReader().FileUnits(lengths, angles, solid_angles);
  if (!lengths.IsEmpty()) set_unit(read, lengths.First().ToCString());
  for (const TCollection_AsciiString& other : lengths)
    if (!other.IsEqual(lengths.First())) read.unit_mm = 0.0;
  require(reader.Transfer(read.document), file, "holds no surface that is read, expected at least one");
  warn_of_failures(read, reader.Reader().WS());
}

void read_iges(const std::string& file, CadDocument& read) {
  IGESCAFControl_Reader reader;
  set_modes(reader);
  require(reader.ReadFile(file.c_str()) == IFSelect_RetDone, file, "is not read as an IGES file: damaged?");
  const Handle(IGESData_IGESModel) model = Handle(IGESData_IGESModel)::DownCast(reader.Model());
  if (!model.IsNull()) set_unit(read, model->GlobalSection().UnitValue());
  require(reader.Transfer(read.document), file, "holds no surface that is read, expected at least one");
  warn_of_failures(read, reader.WS());
}

void read_brep(const std::string& file, CadDocument& read) {
  TopoDS_Shape shape;
  BRep_Builder builder;
  require(BRepTools::Read(shape, file.c_str(), builder) && !shape.IsNull(), file,
          "is not read as an Open CASCADE BREP file: damaged?");
  XCAFDoc_DocumentTool::ShapeTool(read.document->Main())->AddShape(shape, false);
}

}  // namespace

CadDocument read_cad_document(const std::filesystem::path& file, FileFormat format) {
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
  CadDocument read;
  XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", read.document);
  // The readers' own default; said, because a library that a program shares may have set another.
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  if (format == FileFormat::step)
    read_step(file.string(), read);
  else if (format == FileFormat::iges)
    read_iges(file.string(), read);
  else
    read_brep(file.string(), read);
  return read;
}

}  // namespace lrcs
