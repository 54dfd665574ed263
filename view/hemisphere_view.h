#pragma once
#include "view/canvas.h"

namespace lrcs {

// How the disc of scattering directions, with a height above each, lies on a canvas: a parallel projection from
// obliquely above.
// frame: a direction's distance from the disc's middle is theta_r, its azimuth phi: the transmitter's side (0) to the
//   right, the specular side (180) to the left, as in the plots in the plane of incidence.
struct HemisphereView {
  static constexpr double viewer_azimuth_deg = -68.0;
  static constexpr double viewer_elevation_deg = 25.0;

  Point centre;                  // of the disc, at height 0
  double radius = 0.0;           // of the disc, across [pixel]
  double rise = 0.0;             // of height 1 [pixel]
  double largest_theta_deg = 0;  // at the disc's rim

  [[nodiscard]] Point at(double theta_deg, double phi_deg, double height) const;

  // Larger is nearer to the viewer; the same for all heights.
  [[nodiscard]] double nearness(double theta_deg, double phi_deg) const;
};

}  // namespace lrcs
