#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace lrcs {

// A BRDF in the plane of incidence: f_r [1/sr] against theta_r, for one theta_i.
// shape: theta_r_deg and f_r_per_sr have one entry a direction; theta_r rises, negative on the specular side.
// domain: angles finite; f_r >= 0. Where f_r is infinite or not a number the line breaks.
//   Different lengths, f_r < 0, or an angle that is not finite: std::invalid_argument.
struct BrdfCurve {
  double theta_i_deg = 0.0;
  std::vector<double> theta_r_deg;
  std::vector<double> f_r_per_sr;
};

// Writes a PNG or SVG, 1600 x 1000 pixels: one curve for each theta_i. Needs no display.
// value: a logarithmic axis where the positive values span more than a factor 50, at most six decades; else linear
//   from 0.
// laws: the same curves give the same bytes.
// domain: at least one curve, else std::invalid_argument.
// error: std::runtime_error where the file cannot be written.
// check: tests/view/brdf_plot_test.cpp.
void draw_brdf_plot(const std::filesystem::path& file, const std::vector<BrdfCurve>& curves, const std::string& title);

// The curves of one material.
struct BrdfCurves {
  std::string material;
  std::vector<BrdfCurve> curves;
};

// The same of several materials: the colour tells theta_i, the dashes the material. Of more than seven incidence angles
// seven spread ones, which the picture says.
// domain: one to six materials, the same theta_i in the same order in each.
void draw_brdf_comparison(const std::filesystem::path& file, const std::vector<BrdfCurves>& materials,
                          const std::string& title);

}  // namespace lrcs
