#pragma once
#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>
#include <TopoDS_Shape.hxx>
#include <cmath>

namespace lrcs {

// Diagonal of the shape's box, a little too long at most [mm]; 0 for what has no extent.
[[nodiscard]] inline double diagonal_of(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::AddClose(shape, box);
  return box.IsVoid() ? 0.0 : std::sqrt(box.SquareExtent());
}

}  // namespace lrcs
