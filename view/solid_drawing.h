#pragma once
#include <vector>

#include "mesh/facet_mesh.h"
#include "view/colour.h"
#include "view/parallel_view.h"
#include "view/png.h"

namespace lrcs {

// The mesh with one colour a facet, hidden parts hidden, creases over 30 deg and rims in thin dark lines, on white.
// shape: colours: one a facet; picture: width x height pixels; `view.box` lies inside it.
// laws: the same input gives the same picture on the same machine.
// error: std::runtime_error, one line, where OpenGL cannot draw (view/private_display.h).
[[nodiscard]] Picture solid_drawing(const FacetMesh& mesh, const std::vector<Colour>& colours, const ParallelView& view,
                                    int width, int height);

}  // namespace lrcs
