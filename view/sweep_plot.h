#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "view/cartesian_frame.h"

namespace lrcs {

// One cut through the directions: LRCS against one angle.
// shape: angle_deg and sigma_m2 have one entry a direction, in any order and spacing; bound_m2 too, or none at all.
// domain: angles finite; sigma and its bound finite and >= 0 [m^2]. Else, or with different lengths,
// std::invalid_argument.
struct Curve {
  std::string label;
  std::vector<double> angle_deg;
  std::vector<double> sigma_m2;
  std::vector<double> bound_m2 = {};  // the true value lies within sigma - bound and sigma + bound
};

// Which angle a cut runs along: decides how a polar cut lies on the paper.
enum class CutAngle { azimuth, elevation, other };

struct PlotText {
  std::string title;
  std::string angle_axis;  // with its unit: "azimuth [deg]"
  CutAngle angle = CutAngle::azimuth;
  std::optional<double> floor_dbsm = {};  // the lowest that is drawn; none: about 60 dB below the highest point
};

// Writes plots of cuts in dBsm = 10 log10(sigma / 1 m^2), PNG or SVG by the file's name. They need no display and no
// graphics driver.
// value: what lies below the floor is not drawn: the line stops there (in a polar plot at the centre) and breaks beside
//   sigma = 0. The plot says so, with the floor in dBsm; in a Cartesian plot ticks on the floor mark those directions.
//   Up to 60 directions also get a dot each. A curve that comes back to its start within its own spacing is drawn
//   closed, and angles that jump from 360 to 0 run on, but where CutAngle is other. From sigma - bound to sigma + bound
//   lies a light band in the curve's colour, if it is wide enough to be seen; the curves are thin lines then, and the
//   plot says what the band is.
// laws: the same curves give the same bytes.
// domain: at least one curve, the floor below the highest point, else std::invalid_argument; up to a dozen stay
//   readable. A legend names two or more.
// error: std::runtime_error where the file cannot be written.
// check: tests/view/sweep_plot_test.cpp finds peaks, floors and gaps where they belong; sweep_band_test.cpp bands.

// Cartesian, 1600 x 1000 pixels: dBsm against the angle.
void draw_sweep_plot(const std::filesystem::path& file, const std::vector<Curve>& curves, const PlotText& text);
// The same over a whole canvas of any size that leaves room for its letters.
CartesianFrame draw_sweep_plot(Canvas& canvas, const std::vector<Curve>& curves, const PlotText& text);

// Polar, 1200 x 1200 pixels: the radius is dBsm, the floor is the centre.
// frame: azimuth: as seen from above, the nose (0 deg) up, 90 deg to the left as on the target;
//   elevation: as seen from the target's right side, the nose (0 deg) to the right, 90 deg up;
//   other: as elevation, the nose not named.
void draw_polar_plot(const std::filesystem::path& file, const std::vector<Curve>& curves, const PlotText& text);
void draw_polar_plot(Canvas& canvas, const std::vector<Curve>& curves, const PlotText& text);

}  // namespace lrcs
