#pragma once
#include <filesystem>

#include "base/vec3.h"
#include "mesh/facet_mesh.h"
#include "view/facet_result.h"

namespace lrcs {

// Writes a PNG or SVG of the target, coloured by what each facet returns in one direction of a sweep.
// value: colour is sigma_m2 / area of the facet, in dB below the brightest facet, viridis from -40 dB (and less) to 0;
//   light grey: the facet is not lit and seen. Colours are a little darker where a facet is turned away from the
//   viewer, and creases and rims are drawn, so that the shape can be read.
// frame: parallel projection, seen from 25 deg above and 30 deg beside the receiver, `up` upward. Triad: x forward,
//   y left, z up. Arrows point to the receiver, and to the transmitter where it is elsewhere.
// shape: width x height pixels.
// domain: mesh in the body frame, measured (measure_facets), not empty; result as FacetResult; toward_receiver and up
//   not zero; width and height in 400..8000. Else std::invalid_argument.
// laws: the same input gives the same bytes on the same machine.
// error: std::runtime_error, one line, where no 3-D picture can be drawn (view/private_display.h) or no file written.
// check: tests/view/facets_picture_test.cpp finds bright, dim and unseen facets in their colours and places.
void draw_facets_picture(const std::filesystem::path& file, const FacetMesh& mesh, const FacetResult& result,
                         const Vec3& toward_receiver, const Vec3& up, int width, int height);

}  // namespace lrcs
