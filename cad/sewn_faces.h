#pragma once
#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopoDS_Shape.hxx>

namespace lrcs {

// A product's surfaces outside solids, joined along the edges that they have in common within a millionth of the
// product's size. IGES files give every face edges of its own: facets of neighbours would not meet.
struct SewnFaces {
  TopoDS_Shape shape;                    // all of them, turned alike where they form a shell
  TopTools_DataMapOfShapeShape face_of;  // what a face of the product became; none: it was too small to be kept
};

[[nodiscard]] SewnFaces sewn_faces(const TopoDS_Shape& product);

}  // namespace lrcs
