#pragma once
#include <string>
#include <vector>

#include "brdf/material.h"

namespace lrcs {

// Which pictures `lrcs brdf` draws, into which PNG or SVG files; an empty name: not that one.
struct BrdfPictures {
  std::string curves;             // f_r in the plane of incidence
  std::string shadowing;          // G in the plane of incidence
  std::string surface;            // f_r over the scattering directions, for the first theta_i
  std::string surface_shadowing;  // G over them
};

// error: InputError for a file that does not end in .png or .svg, whose folder is not there or that two flags name, and
//   where a picture asked for cannot be of these materials: G of a model without a shadowing function, more materials
//   than curves in a plot can be told apart, materials to compare with but no plot of curves.
void require_drawable(const BrdfPictures& pictures, const std::vector<Material>& materials);

// The first material, in plots of curves beside the others. All values are there before the first file is written.
// domain: require_drawable passed; theta_i in [0, 90).
void draw_brdf_pictures(const BrdfPictures& pictures, const std::vector<Material>& materials,
                        const std::vector<double>& theta_i_deg);

}  // namespace lrcs
