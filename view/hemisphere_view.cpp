#include "view/hemisphere_view.h"

#include <cmath>

#include "base/vec3.h"

namespace lrcs {

Point HemisphereView::at(double theta_deg, double phi_deg, double height) const {
  const double from_middle = radius * theta_deg / largest_theta_deg;
  const double aside = (phi_deg - viewer_azimuth_deg) * degree;
  return {centre.x + from_middle * std::sin(aside),
          centre.y - from_middle * std::cos(aside) * std::sin(viewer_elevation_deg * degree) + rise * height};
}

double HemisphereView::nearness(double theta_deg, double phi_deg) const {
  return theta_deg * std::cos((phi_deg - viewer_azimuth_deg) * degree);
}

}  // namespace lrcs
