#pragma once
#include <string>
#include <vector>

#include "lrcs/sweep.h"
#include "view/sweep_plot.h"

namespace lrcs {

// A sweep as curves to draw: sigma against azimuth, one curve an elevation; against elevation where the azimuth is
// always the same; against the row's number for a list of loose directions.
struct Cuts {
  std::vector<Curve> curves;  // at most `most_curves`; the rest is left out
  std::string axis;           // "azimuth [deg]", ...
  CutAngle angle = CutAngle::azimuth;
  std::size_t left_out = 0;  // curves not drawn
};

inline constexpr std::size_t most_curves = 7;

[[nodiscard]] Cuts cuts_of(const std::vector<SweepRow>& rows);

}  // namespace lrcs
