#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "view/brdf_axes.h"

namespace lrcs {

// A measured BRDF and its fit in the plane of incidence, for one theta_i.
// shape: one value an angle, and one residual a measured point; measured points in any order, fitted angles rise.
// domain: all finite, but a residual that is not a number is not drawn; fitted f_r >= 0; measured f_r of either sign
//   (noise). At least one measured and one fitted point.
struct FitCurve {
  double theta_i_deg = 0.0;
  std::vector<double> measured_theta_r_deg;  // negative: the specular side, as in the tables of brdf/brdf_table.h
  std::vector<double> measured_f_r_per_sr;
  std::vector<double> fitted_theta_r_deg;
  std::vector<double> fitted_f_r_per_sr;
  std::vector<double> residual;  // of a measured point, as ResidualKind says
};

// What the residuals are: the difference of the f_r cos theta_r [% of the largest measured one], or
// ln(fitted/measured).
enum class ResidualKind { percent_of_largest, logarithm };

inline constexpr std::size_t most_incidences_of_a_fit = 8;  // as many as there are symbols

struct FitPicture {
  std::string title;
  std::string note;  // below the title; its lines one below the other
  std::vector<FitCurve> curves;
  ValueScale scale = ValueScale::automatic;
  ResidualKind residuals = ResidualKind::percent_of_largest;
};

// Writes a PNG or SVG, 1600 x 1300 pixels: above, measured points as symbols and the fit as lines, a colour and a
// symbol for each theta_i; below, the residuals. Needs no display.
// value: the scale as in view/brdf_axes.h. The picture says how many measured points lie below a logarithmic axis. Of
//   symbols so near one another that they cannot be told apart one is drawn.
// laws: the same picture gives the same bytes, whatever the order of its curves where their theta_i differ.
// domain: one to eight curves, valid ones; else std::invalid_argument.
// error: std::runtime_error where the file cannot be written.
// check: tests/view/fit_plot_test.cpp.
void draw_fit_plot(const std::filesystem::path& file, const FitPicture& picture);

}  // namespace lrcs
