#include "cad/cad_parts.h"

#include <fmt/format.h>

#include <Quantity_Color.hxx>
#include <TColStd_HSequenceOfExtendedString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDataStd_TreeNode.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopoDS.hxx>
#include <XCAFDoc.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_MaterialTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <algorithm>

#include "base/input_error.h"
#include "cad/part_names.h"
#include "cad/sewn_faces.h"

namespace lrcs {
namespace {

std::string utf8(const TCollection_ExtendedString& words) {
  std::string text = TCollection_AsciiString(words, 0).ToCString();
  // Names stand in lines of text.
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  return text;
}

std::string name_of(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  return label.FindAttribute(TDataStd_Name::GetID(), name) ? utf8(name->Get()) : std::string();
}

// What `more` leaves unsaid, `rest` says.
CadLook either(CadLook more, const CadLook& rest) {
  if (more.colour.empty()) more.colour = rest.colour;
  if (more.layer.empty()) more.layer = rest.layer;
  if (more.material.empty()) more.material = rest.material;
  return more;
}

struct Placed {
  TDF_Label product;
  TopLoc_Location location;
  std::string path;
  CadLook look;  // of what it is part of, and its own
};

class Walk {
 public:
  Walk(const CadDocument& read, const std::string& file)
      : file_(file),
        shapes_(XCAFDoc_DocumentTool::ShapeTool(read.document->Main())),
        colours_(XCAFDoc_DocumentTool::ColorTool(read.document->Main())),
        layers_(XCAFDoc_DocumentTool::LayerTool(read.document->Main())),
        materials_(XCAFDoc_DocumentTool::MaterialTool(read.document->Main())) {}

  std::vector<CadPart> run() {
    TDF_LabelSequence free;
    shapes_->GetFreeShapes(free);
    push({free, TopLoc_Location(), "", {}});
    // Files may nest assemblies as deep as they like.
    while (!waiting_.empty()) {
      const Placed next = waiting_.back();
      waiting_.pop_back();
      if (shapes_->IsAssembly(next.product)) {
        TDF_LabelSequence components;
        shapes_->GetComponents(next.product, components);
        push({components, next.location, next.path + "/", next.look});
      } else {
        add_parts(next);
      }
    }
    number_equal_paths();
    return std::move(parts_);
  }

 private:
  struct Siblings {
    TDF_LabelSequence labels;
    TopLoc_Location location;
    std::string path;
    CadLook look;
  };

  // A name of the file may be what a numbered one became.
  void number_equal_paths() {
    std::vector<std::string> paths;
    paths.reserve(parts_.size());
    for (const CadPart& part : parts_) paths.push_back(part.path);
    paths = numbered(std::move(paths), "");
    for (std::size_t k = 0; k < parts_.size(); ++k) parts_[k].path = paths[k];
  }

  [[nodiscard]] TDF_Label product_of(const TDF_Label& instance) const {
    TDF_Label product = instance;
    if (shapes_->IsReference(instance)) shapes_->GetReferredShape(instance, product);
    return product;
  }

  void push(const Siblings& siblings) {
    std::vector<std::string> names;
    for (const TDF_Label& label : siblings.labels) {
      const std::string of_product = name_of(product_of(label));
      names.push_back(of_product.empty() ? name_of(label) : of_product);
    }
    names = numbered(names, "part");
    const std::size_t first = waiting_.size();
    std::size_t k = 0;
    for (const TDF_Label& label : siblings.labels) {
      const TDF_Label product = product_of(label);
      const CadLook own = either(look_of(label), look_of(product));
      // A product's shape may itself be placed.
      const TopLoc_Location here = label == product ? TopLoc_Location() : shapes_->GetLocation(label);
      waiting_.push_back({product, siblings.location * here, siblings.path + names[k++], either(own, siblings.look)});
    }
    std::reverse(waiting_.begin() + static_cast<std::ptrdiff_t>(first), waiting_.end());
    require_few(parts_.size() + waiting_.size());
  }

  void require_few(std::size_t parts) const {
    if (parts > most_parts)
      throw InputError(Place{file_}, fmt::format("has more than {} parts, expected at most these", most_parts));
  }

  [[nodiscard]] CadLook look_of(const TDF_Label& label) const {
    CadLook look;
    Quantity_Color colour;
    for (const XCAFDoc_ColorType type : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen})
      if (look.colour.empty() && colours_->GetColor(label, type, colour)) look.colour = hexadecimal(colour);
    Handle(TColStd_HSequenceOfExtendedString) layers;
    if (layers_->GetLayers(label, layers) && !layers.IsNull() && !layers->IsEmpty()) look.layer = utf8(layers->First());
    look.material = material_of(label);
    return look;
  }

  // The name of the material that a label refers to.
  [[nodiscard]] std::string material_of(const TDF_Label& label) const {
    Handle(TDataStd_TreeNode) node;
    if (!label.FindAttribute(XCAFDoc::MaterialRefGUID(), node) || !node->HasFather()) return "";
    Handle(TCollection_HAsciiString) name, description, density_name, density_type;
    double density = 0.0;
    const bool found =
        materials_->GetMaterial(node->Father()->Label(), name, description, density, density_name, density_type);
    return found && !name.IsNull() ? utf8(TCollection_ExtendedString(name->String())) : std::string();
  }

  static std::string hexadecimal(const Quantity_Color& colour) {
    std::string text = Quantity_Color::ColorToHex(colour, true).ToCString();
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
  }

  // Of this occurrence alone, where the assembly that it is in is placed several times.
  [[nodiscard]] CadLook look_of_occurrence(const TopoDS_Shape& shape) const {
    CadLook look;
    Quantity_Color colour;
    for (const XCAFDoc_ColorType type : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen})
      if (look.colour.empty() && colours_->GetInstanceColor(shape, type, colour)) look.colour = hexadecimal(colour);
    return look;
  }

  // A product's solids, and what lies outside them.
  void add_parts(const Placed& placed) {
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(placed.product);
    if (shape.IsNull()) return;
    const Subshapes known(*this, placed.product);
    const CadLook whole = either(look_of_occurrence(shape.Moved(placed.location, false)), placed.look);
    std::vector<TopoDS_Shape> bodies;
    std::vector<std::string> names;
    for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next()) {
      bodies.push_back(solid.Current());
      names.push_back(known.name(solid.Current()));
    }
    names = numbered(names, "solid");
    const bool has_surfaces = TopExp_Explorer(shape, TopAbs_FACE, TopAbs_SOLID).More();
    const bool is_one = bodies.size() == 1 && !has_surfaces;
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      begin_part(is_one ? placed.path : placed.path + "/" + names[k], bodies[k]);
      const CadLook look = either(known.look(bodies[k]), whole);
      for (TopExp_Explorer face(bodies[k], TopAbs_FACE); face.More(); face.Next())
        add_face(face.Current(), placed, either(known.look(face.Current()), look));
    }
    if (!has_surfaces) return;
    const SewnFaces& sewn = sewn_once(shape);
    begin_part(bodies.empty() ? placed.path : placed.path + "/surfaces", sewn.shape);
    for (TopExp_Explorer face(shape, TopAbs_FACE, TopAbs_SOLID); face.More(); face.Next())
      if (const TopoDS_Shape* became = sewn.face_of.Seek(face.Current()))
        add_face(*became, placed, either(known.look(face.Current()), whole));
  }

  // What a product has outside solids, the same for all its instances.
  const SewnFaces& sewn_once(const TopoDS_Shape& product) {
    if (!sewn_.IsBound(product)) {
      sewn_.Bind(product, static_cast<int>(sewn_faces_.size()));
      sewn_faces_.push_back(sewn_faces(product));
    }
    return sewn_faces_[static_cast<std::size_t>(sewn_.Find(product))];
  }

  void begin_part(const std::string& path, const TopoDS_Shape& product) {
    require_few(parts_.size() + waiting_.size() + 1);
    parts_.push_back({path, product, {}});
  }

  void add_face(const TopoDS_Shape& face, const Placed& placed, const CadLook& look) {
    parts_.back().faces.push_back({TopoDS::Face(face.Moved(placed.location, false)), look});
  }

  // The labels of a product's own solids and faces.
  class Subshapes {
   public:
    Subshapes(const Walk& walk, const TDF_Label& product) : walk_(walk) {
      XCAFDoc_ShapeTool::GetSubShapes(product, labels_);
      int k = 0;
      for (const TDF_Label& label : labels_) index_.Bind(XCAFDoc_ShapeTool::GetShape(label), ++k);
    }
    [[nodiscard]] CadLook look(const TopoDS_Shape& shape) const {
      const int* k = index_.Seek(shape);
      return k == nullptr ? CadLook{} : walk_.look_of(labels_.Value(*k));
    }
    [[nodiscard]] std::string name(const TopoDS_Shape& shape) const {
      const int* k = index_.Seek(shape);
      return k == nullptr ? std::string() : name_of(labels_.Value(*k));
    }

   private:
    const Walk& walk_;
    TDF_LabelSequence labels_;
    TopTools_DataMapOfShapeInteger index_;
  };

  const std::string& file_;
  Handle(XCAFDoc_ShapeTool) shapes_;
  Handle(XCAFDoc_ColorTool) colours_;
  Handle(XCAFDoc_LayerTool) layers_;
  Handle(XCAFDoc_MaterialTool) materials_;
  TopTools_DataMapOfShapeInteger sewn_;  // index into sewn_faces_
  std::vector<SewnFaces> sewn_faces_;
  std::vector<Placed> waiting_;
  std::vector<CadPart> parts_;
};

}  // namespace

std::vector<CadPart> cad_parts(const CadDocument& read, const std::string& file) {
  return Walk(read, file).run();
}

}  // namespace lrcs
