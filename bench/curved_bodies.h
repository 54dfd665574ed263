#pragma once
#include <string>
#include <vector>

#include "lrcs/aspect.h"
#include "lrcs/cross_section.h"

namespace lrcs {

// A round body as a STEP file's reader sees it, with the sigma of its true surface.
struct CurvedBody {
  std::string name;
  std::string step;             // the file's content
  std::vector<Aspect> aspects;  // from which it does not shade itself
  std::vector<double> sigma;    // [m^2], one an aspect
};

// Sphere, cylinder, cone, torus from above, ellipsoid, all about 2 m across, made by Open CASCADE; of a material.
// error: of sigma: 1e-8, by quadrature over the surface.
[[nodiscard]] std::vector<CurvedBody> curved_bodies(const Brdf& brdf);

// A field of boxes that shade each other; with the sigma of flat facets.
[[nodiscard]] CurvedBody planar_body(const Brdf& brdf);

// What facets stand for.
enum class Facets { flat, of_surface, of_estimated_normals };

// The body with facets that turn by at most so much from edge to edge, of a material.
[[nodiscard]] Target target_of(const CurvedBody& body, double angle_deg, Facets facets, const Brdf& brdf);

}  // namespace lrcs
