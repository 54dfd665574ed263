#pragma once
#include <optional>

#include "cad/curving.h"

namespace lrcs {

// How finely surfaces of CAD files become facets: facets' edges stay within a chord tolerance of the surface, and turn
// by no more than an angle from one to the next.
struct Tessellation {
  double relative = 1e-3;          // chord tolerance over the diagonal of the part's box [1]
  std::optional<double> absolute;  // chord tolerance [m]; where it is given it counts instead
  double angle_deg = 8.0;          // [deg]
  Curving curving = {};            // what else facets are to know of the surfaces that they stand for
};

}  // namespace lrcs
