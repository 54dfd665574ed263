#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace lrcs {

// A function of the scattering direction, for one theta_i: f_r [1/sr], a shadowing function G [1].
// frame: theta_r from the normal, phi from the transmitter's azimuth; phi = 180 deg is the specular side.
// shape: value[t * phi_deg.size() + p] is that at theta_r_deg[t] and phi_deg[p].
// domain: theta_r rises from 0 to at most 90, two angles or more; phi rises within [0, 360) and goes once round (it is
//   closed from the last to the first), three angles or more; values finite, >= 0.
struct HemisphereValues {
  std::vector<double> theta_r_deg;
  std::vector<double> phi_deg;
  std::vector<double> value;
};

struct SurfaceText {
  std::string title;
  std::string note;
  std::string value_axis;   // with its unit: "BRDF [1/sr]"
  double full_scale = 0.0;  // the axis reaches this at least
};

// Writes a PNG or SVG, 1600 x 1300 pixels: the value as height and colour over the disc of directions, hidden parts
// hidden. Needs no display and no graphics driver.
// value: linear, from 0; lines on the surface every 10 deg of theta_r and every 30 deg of phi where the grid has them.
// laws: the same values give the same bytes.
// domain: valid values, else std::invalid_argument. error: std::runtime_error where the file cannot be written.
// check: tests/view/brdf_surface_test.cpp finds the highest point where it belongs.
void draw_brdf_surface(const std::filesystem::path& file, const HemisphereValues& values, const SurfaceText& text);

}  // namespace lrcs
