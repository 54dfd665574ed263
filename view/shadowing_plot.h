#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace lrcs {

// A shadowing function G in the plane of incidence, against theta_r for one theta_i.
// shape: one value an angle; theta_r rises, negative on the specular side.
struct ShadowingCurve {
  double theta_i_deg = 0.0;
  std::vector<double> theta_r_deg;
  std::vector<double> shadowing;  // [1]
};

// The curves of one material (one set of parameters).
struct ShadowingCurves {
  std::string material;
  std::vector<ShadowingCurve> curves;
};

// Writes a PNG or SVG, 1600 x 1000 pixels: G from 0 to 1; the colour tells theta_i, the dashes the material. Needs no
// display.
// value: of more than seven incidence angles seven spread ones, which the picture says; the note stands above that.
// laws: the same curves give the same bytes.
// domain: one to six materials, the same theta_i in the same order in each; angles finite, G in [0, 1]. Else
//   std::invalid_argument. error: std::runtime_error where the file cannot be written.
// check: tests/view/shadowing_plot_test.cpp.
void draw_shadowing_plot(const std::filesystem::path& file, const std::vector<ShadowingCurves>& materials,
                         const std::string& title, const std::string& note = "");

}  // namespace lrcs
