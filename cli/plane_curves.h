#pragma once
#include <string>
#include <vector>

#include "brdf/brdf.h"
#include "view/shadowing_plot.h"

namespace lrcs {

// A material's values in the plane of incidence, for pictures. theta_r_deg: as in the tables of brdf/brdf_table.h
// negative on the specular side.

[[nodiscard]] double f_r_in_plane(const Brdf& brdf, double theta_i_deg, double theta_r_deg);

// -steps..steps times half a degree.
[[nodiscard]] std::vector<double> half_degrees(int steps);

// G of the named material, one curve a theta_i. domain: the model has a shadowing function.
[[nodiscard]] bool has_shadowing(const Brdf& brdf);
[[nodiscard]] ShadowingCurves shadowing_curves(const std::string& material, const Brdf& brdf,
                                               const std::vector<double>& theta_i_deg);

}  // namespace lrcs
