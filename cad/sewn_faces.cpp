#include "cad/sewn_faces.h"

#include <BRepBuilderAPI_Sewing.hxx>
#include <TopExp_Explorer.hxx>

#include "cad/shape_size.h"

namespace lrcs {

SewnFaces sewn_faces(const TopoDS_Shape& product) {
  constexpr double tolerance = 1e-6;
  BRepBuilderAPI_Sewing sewing(tolerance * diagonal_of(product));
  for (TopExp_Explorer face(product, TopAbs_FACE, TopAbs_SOLID); face.More(); face.Next()) sewing.Add(face.Current());
  sewing.Perform();
  SewnFaces sewn;
  sewn.shape = sewing.SewedShape();
  // Which way a face is turned, its place in the result tells.
  TopTools_DataMapOfShapeShape turned;
  for (TopExp_Explorer face(sewn.shape, TopAbs_FACE); face.More(); face.Next())
    turned.Bind(face.Current(), face.Current());
  for (TopExp_Explorer face(product, TopAbs_FACE, TopAbs_SOLID); face.More(); face.Next()) {
    const TopoDS_Shape became =
        sewing.IsModified(face.Current()) ? sewing.Modified(face.Current()) : TopoDS_Shape(face.Current());
    if (const TopoDS_Shape* found = turned.Seek(became)) sewn.face_of.Bind(face.Current(), *found);
  }
  return sewn;
}

}  // namespace lrcs
