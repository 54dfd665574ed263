#pragma once
#include <string>

#include "brdf/brdf.h"

namespace lrcs {

// What a surface is made of, at one wavelength.
struct Material {
  std::string name;
  Brdf brdf;                // black unless set
  double wavelength = 0.0;  // [m] the BRDF was measured at; 0: not stated
  std::string source;       // where the numbers come from; may be empty
};

}  // namespace lrcs
