#pragma once
#include <string>

#include "mesh/facet_mesh.h"

namespace lrcs {

// Brings a mesh from its file's axes and unit into the body frame: x forward, y left, z up.
// value: positions (p.forward, p.(up x forward), p.up), still in the file's unit; metres_per_unit is noted in the mesh,
// and normals and areas [m^2] are measured. domain: forward and up: one of +x -x +y -y +z -z (x stands for +x), not
// along the same axis; metres_per_unit finite and above zero; else std::invalid_argument that says what was expected.
// laws: a rotation, never a reflection; coordinates are permuted and signed, exactly: the unit changes no decision.
void place_in_body_frame(FacetMesh& mesh, double metres_per_unit, const std::string& forward, const std::string& up);

}  // namespace lrcs
