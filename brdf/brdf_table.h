#pragma once
#include <string>
#include <vector>

#include "brdf/albedo.h"
#include "brdf/material.h"

namespace lrcs {

// What `lrcs brdf` writes: f_r in the plane of incidence, as CSV that `lrcs fit` reads.
// shape: per theta_i the rows theta_r = -largest..largest in steps that pass 0;
//        columns theta_i_deg, theta_r_deg, phi_deg, f_r_per_sr, G.
//        phi is 0 throughout: a negative theta_r is the other side of the normal, the specular one.
//        G: the shadowing function; 1 for a model without.
// header: comments with material, wavelength, azimuth_of_specular (of the angles in the table: 180; the material's own
//        convention is among its parameters), albedo per theta_i with its bound, and the warnings below.
// A tabulated BRDF that was not measured everywhere and whose rule is Outside::error: rows of such directions are left
//   out and named in a comment, an albedo is that of the directions measured, a lower bound.
// domain: theta_i, largest_theta_r_deg in [0, 90), step_deg > 0, at most 100000 rows; else std::domain_error.
[[nodiscard]] std::string brdf_table(const Material& material, const std::vector<double>& theta_i_deg,
                                     double step_deg = 10.0, double largest_theta_r_deg = 80.0);

// Where a user would be misled, a sentence each: what a measurement warns of, the albedo passes 1 (looked for at whole
// degrees up to 89), f_r is not reciprocal (by how much at worst, on a grid up to 80 deg).
[[nodiscard]] std::vector<std::string> brdf_warnings(const Brdf& brdf);

// What `lrcs materials` writes: one line a material of the library: name, model, wavelength, parameters, source.
[[nodiscard]] std::string materials_table();

// "five_parameter kb=0.117 kr=0.321 ... azimuth_of_specular=180"
[[nodiscard]] std::string description_of(const Brdf& brdf);

}  // namespace lrcs
