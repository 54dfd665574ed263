#pragma once
#include <string>
#include <vector>

#include "view/cartesian_frame.h"
#include "view/extent.h"

namespace lrcs {

// The axes that plots of BRDFs share.

// How values lie on their axis. automatic: logarithmic where the positive ones span more than a factor 50.
enum class ValueScale { automatic, linear, logarithmic };

// Of scattering angles [deg]; ends on a mark where one is near. An empty extent: about 0.
[[nodiscard]] Axis scattering_axis(const Extent& angles, const std::string& title = "scattering angle [deg]");

// Of f_r [1/sr]. linear: from 0, or from below it if `all` does; logarithmic: whole decades of `positive`, at most six,
// labelled 0.001 to 1000 where all lie there, else all as powers of ten.
// domain: `positive` holds the positive values of `all`; where it is empty the axis is linear.
[[nodiscard]] Axis f_r_axis(const Extent& all, const Extent& positive, ValueScale scale = ValueScale::automatic);

// From 0, or a mark below `lowest`, to a mark not below `highest`, in at most `most` steps. domain: highest > lowest.
[[nodiscard]] Axis linear_axis(const std::string& title, double lowest, double highest, int most = 6);

// From -reach to reach, marks inside it only: three to five. domain: reach > 0.
[[nodiscard]] Axis symmetric_axis(const std::string& title, double reach);

// "scattering angle [deg] (negative: ...)": where the sign is the tables' one, see brdf/brdf_table.h.
inline constexpr const char* signed_scattering_angle = "scattering angle [deg] (negative: the specular side)";

// "incidence 30°"
[[nodiscard]] std::string incidence_label(double theta_i_deg);

// A line through the points that can be drawn; it breaks where a value is not finite, or not positive on a logarithmic
// axis. shape: as many x as y.
void draw_broken_line(Canvas& canvas, const CartesianFrame& frame, const std::vector<double>& x,
                      const std::vector<double>& y, const Pen& pen);

}  // namespace lrcs
