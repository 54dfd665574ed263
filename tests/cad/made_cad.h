#pragma once
#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepTools.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Controller.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <filesystem>
#include <numbers>
#include <string>

namespace lrcs {

inline TopoDS_Shape box_of(double x, double y, double z) {
  return BRepPrimAPI_MakeBox(x, y, z).Shape();
}

// A sphere, stretched along x, y and z.
inline TopoDS_Shape ellipsoid_of(double radius, double a, double b, double c) {
  gp_GTrsf stretch;
  stretch.SetValue(1, 1, a), stretch.SetValue(2, 2, b), stretch.SetValue(3, 3, c);
  return BRepBuilderAPI_GTransform(BRepPrimAPI_MakeSphere(radius).Shape(), stretch, true).Shape();
}

inline TopLoc_Location moved_by(double x, double y, double z) {
  gp_Trsf t;
  t.SetTranslation(gp_Vec(x, y, z));
  return {t};
}

// A CAD document that a test puts together, lengths in millimetres.
class MadeCad {
 public:
  MadeCad() {
    Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
    XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document_);
  }

  TDF_Label product(const TopoDS_Shape& shape, const char* name) {
    const TDF_Label label = shapes()->AddShape(shape, false);
    TDataStd_Name::Set(label, name);
    return label;
  }
  TDF_Label assembly(const char* name) {
    const TDF_Label label = shapes()->NewShape();
    TDataStd_Name::Set(label, name);
    return label;
  }
  TDF_Label place(const TDF_Label& assembly, const TDF_Label& product, const TopLoc_Location& where) {
    const TDF_Label label = shapes()->AddComponent(assembly, product, where);
    shapes()->UpdateAssemblies();
    return label;
  }
  void colour(const TDF_Label& label, const char* hexadecimal) {
    colours()->SetColor(label, colour_of(hexadecimal), XCAFDoc_ColorSurf);
  }
  // Of the product's face number k.
  void colour_face(const TDF_Label& product, int k, const char* hexadecimal) {
    TopExp_Explorer face(XCAFDoc_ShapeTool::GetShape(product), TopAbs_FACE);
    for (; k > 0; --k) face.Next();
    colours()->SetColor(shapes()->AddSubShape(product, face.Current()), colour_of(hexadecimal), XCAFDoc_ColorSurf);
  }
  void layer(const TDF_Label& label, const char* name) {
    XCAFDoc_DocumentTool::LayerTool(document_->Main())->SetLayer(label, TCollection_ExtendedString(name));
  }

  // unit: MM, M, INCH, ... schema: AP203, AP214IS or AP242DIS.
  void write_step(const std::filesystem::path& file, const char* unit = "MM", const char* schema = "AP214IS") {
    STEPControl_Controller::Init();
    Interface_Static::SetCVal("write.step.schema", schema);
    Interface_Static::SetCVal("write.step.unit", unit);
    STEPCAFControl_Writer writer;
    writer.SetColorMode(true);
    writer.SetNameMode(true);
    writer.SetLayerMode(true);
    writer.Transfer(document_, STEPControl_AsIs);
    writer.Write(file.c_str());
  }

 private:
  Handle(XCAFDoc_ShapeTool) shapes() { return XCAFDoc_DocumentTool::ShapeTool(document_->Main()); }
  Handle(XCAFDoc_ColorTool) colours() { return XCAFDoc_DocumentTool::ColorTool(document_->Main()); }
  static Quantity_Color colour_of(const char* hexadecimal) {
    Quantity_Color colour;
    Quantity_Color::ColorFromHex(hexadecimal, colour);
    return colour;
  }

  Handle(TDocStd_Document) document_;
};

inline void write_brep(const TopoDS_Shape& shape, const std::filesystem::path& file) {
  BRepTools::Write(shape, file.c_str());
}

inline void write_iges(const TopoDS_Shape& shape, const std::filesystem::path& file, const char* unit) {
  IGESControl_Writer writer(unit, 0);
  writer.AddShape(shape);
  writer.Write(file.c_str());
}

}  // namespace lrcs
